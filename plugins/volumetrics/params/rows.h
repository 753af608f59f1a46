// How a parameter table is written. A table is a macro X_PARAMS(INT, FLOAT, ENUM, BOOL) of rows:
//   INT  (field, "id", "label", default, min, max, builtMin, builtMax, "unit", flags, "doc")
//   FLOAT(field, "id", "label", default, min, max, "unit", flags, "doc")
//   ENUM (field, "id", "label", "default", "choices not built yet, joined by |", "a|b|c", flags, "doc")
//   BOOL (field, "id", "label", default, mask of values not built yet (1 false, 2 true), flags, "doc")
// The C++ struct, the GLSL struct, the ABI table (and from it command line, editor, presets, documentation) all expand
// the same rows. flags: 0, TY_PARAMETER_STRUCTURAL (a change needs another layout) and TY_PARAMETER_LOGARITHMIC.
#ifndef TYNDALL_VOLUMETRICS_ROWS_H
#define TYNDALL_VOLUMETRICS_ROWS_H

// Fields of the struct that a shader and the plugin share: numbers are 32-bit, enums and bools are int.
#define TY_FIELD_INT(field, id, label, standard, low, high, builtLow, builtHigh, unit, flags, doc) int field;
#define TY_FIELD_FLOAT(field, id, label, standard, low, high, unit, flags, doc) float field;
#define TY_FIELD_ENUM(field, id, label, standard, unbuilt, choices, flags, doc) int field;
#define TY_FIELD_BOOL(field, id, label, standard, unbuilt, flags, doc) int field;
#define TY_FIELDS(TABLE) TABLE(TY_FIELD_INT, TY_FIELD_FLOAT, TY_FIELD_ENUM, TY_FIELD_BOOL)

#endif

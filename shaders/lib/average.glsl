// Running averages in float without forgetting (Kahan 1965, "Further remarks on reducing truncation errors").
// The plain average += (next - average) * share stands still once a step is below half an ulp: with equal shares, after N columns,
// it ignores differences below N ulp / 2. The moments of one average then belong to different distributions, and no
// bias below 1e-3 makes the bounds safe (docs/results/stress.md). Use, with `rest` starting at zero:
//   Real4 step = (next - average) * share + rest;
//   rest = lostInSum(average, step);
//   average += step;
#ifdef __cplusplus
#define TYNDALL_PRECISE
#else
#define TYNDALL_PRECISE precise
#endif

// What the float sum a + b drops, for |a| >= |b| (exact then).
LIB Real4 lostInSum(Real4 a, Real4 b) {
  TYNDALL_PRECISE Real4 sum = a + b;
  TYNDALL_PRECISE Real4 taken = sum - a;
  TYNDALL_PRECISE Real4 lost = b - taken;
  return lost;
}
#undef TYNDALL_PRECISE

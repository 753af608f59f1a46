// The engine's own parameters; a plugin's come from its table (plugins/abi).
#include "params/params.hpp"

namespace tyndall::params {

std::vector<Parameter> engineParameters() {
  Parameter mode;
  mode.id = "shadows.mode";
  mode.name = "Shadow filtering";
  mode.doc =
      "How shadow maps are filtered when surfaces are lit: pcf averages comparisons of 3x3 texels, moments reads a "
      "blurred map of "
      "four moments, whose shadows have softer edges and do not flicker in the distance.";
  mode.type = Type::kEnum;
  mode.choices = {"pcf", "moments", "soft", "variance", "exponential_variance"};
  mode.built = {true, true, false, false, false};

  Parameter resolution;
  resolution.id = "shadows.resolution";
  resolution.name = "Shadow map size";
  resolution.unit = "texels";
  resolution.doc = "Texels a side of each shadow map, and of each face of a point light's cube map.";
  resolution.type = Type::kInt;
  resolution.defaultValue = 2048;
  // 64: coarser maps show nothing but blocks. 8192: 256 MiB of D32, the largest that a 2D image is sure to be good for.
  resolution.min = resolution.builtMin = 64;
  resolution.max = resolution.builtMax = 8192;
  resolution.structural = true;
  resolution.logarithmic = true;

  Parameter precision;
  precision.id = "shadows.precision";
  precision.name = "Moment precision";
  precision.unit = "bit";
  precision.doc =
      "Bits per texel of moment shadow maps; read by shadows.mode = moments and by volumetrics.filtered_resampling.";
  precision.type = Type::kEnum;
  precision.choices = {"64", "128"};

  Parameter reuse;
  reuse.id = "shadows.reuse";
  reuse.name = "Keep shadow maps";
  reuse.doc =
      "Draws a shadow map again only when its light, a caster or its size has changed; maps then have memory of their "
      "own. A sun's map follows the camera.";
  reuse.type = Type::kBool;

  Parameter sky;
  sky.id = "sky.strength";
  sky.name = "Sky light";
  sky.doc =
      "Factor on the sky's light on surfaces; 0 removes it. What casts shadows hides the sky: a closed room is dark.";
  sky.type = Type::kFloat;
  sky.defaultValue = 1;
  sky.max = sky.builtMax = 100;

  Parameter exposure;
  exposure.id = "view.exposure";
  exposure.name = "Exposure";
  exposure.doc = "Linear factor on radiance before the tone map, on top of what view.auto_exposure or the level says.";
  exposure.type = Type::kFloat;
  exposure.defaultValue = 1;
  exposure.min = exposure.builtMin = 1e-4;
  exposure.max = exposure.builtMax = 1e4;
  exposure.logarithmic = true;

  Parameter automatic;
  automatic.id = "view.auto_exposure";
  automatic.name = "Automatic exposure";
  automatic.doc =
      "Measures the picture and brings its mean to 18 % grey; view.exposure is a factor on top. Unless it is set, a "
      "level whose extras have an exposure is shown with that one.";
  automatic.type = Type::kBool;
  automatic.defaultValue = 1;
  automatic.max = automatic.builtMax = 1;

  std::vector<Parameter> all = {mode, resolution, precision, reuse, sky, exposure, automatic};
  for (Parameter& p : all) p.owner = "engine";
  return all;
}

}  // namespace tyndall::params

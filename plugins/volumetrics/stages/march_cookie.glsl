// What the marches know of cookies. Before it, in shaders whose lights may have cookies: TY_COOKIES, a constant bool, the binding
// `cookieImage` and a CookieBlock `marchCookie`. Without TY_COOKIES no light has one.
#ifdef TY_COOKIES
#include "stages/cookie.glsl"
#include "stages/opaque.glsl"
bool hasCookie() { return TY_COOKIES && opaque(marchCookie.faces) != 0u; }

// Colour at a point of a view ray, averaged over a stratum of `length_` m. Trilinear filtering spreads over two texels of its mip: these
// are to be as long, as the light sees them, as the stratum, or few steps step over a fine image's squares. What the pixel covers is
// not averaged: as with the shadow map one ray stands for it, and with more steps the sum tends to the integral along that ray.
vec3 cookieAlong(vec3 direction, float t, float length_) {
  return cookieColour(marchCookie, direction * t, direction * (0.5 * length_), vec3(0.0));
}
#else
bool hasCookie() { return false; }
vec3 cookieAlong(vec3 direction, float t, float length_) { return vec3(1.0); }
#endif

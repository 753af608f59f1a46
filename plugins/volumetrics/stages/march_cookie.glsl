// What the marches know of cookies. Before it, in shaders whose lights may have cookies: TY_COOKIES, a constant bool, the binding `cookieImage` and a CookieBlock `marchCookie`. Without TY_COOKIES no light has one.
#ifdef TY_COOKIES
#include "stages/cookie.glsl"
bool hasCookie() { return TY_COOKIES && marchCookie.faces != 0u; }

// Colour at a point of a view ray: a sample as the shadow map's is, of the finest mip. Filtered over the pixel, a fine cookie would be blurred across the
// ray, and a march would not tend to the integral along it.
vec3 cookieAlong(vec3 direction, float t) { return cookieColour(marchCookie, direction * t, vec3(0.0), vec3(0.0)); }
#else
bool hasCookie() { return false; }
vec3 cookieAlong(vec3 direction, float t) { return vec3(1.0); }
#endif

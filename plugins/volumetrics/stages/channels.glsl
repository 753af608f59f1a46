// How values per reference ray and colour are packed into texels of four: colours of one reference ray next to each other. Needs
// stages/rows.glsl and kReferenceRays.
const int kColours = kColoured ? 3 : 1;
const int kChannels = kReferenceRays * kColours;
const int kChannelQuads = (kChannels + 3) / 4;
const int kChannelSlots = 4 * kChannelQuads;

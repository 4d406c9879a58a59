// Blades that objects have touched (animation/touched_blades.h) and which move by themselves: their chains
// come from there.
layout(binding = kTouchedCellUnit) uniform usamplerBuffer
    touched_cells;  // by cell of the run: 0, or 1 + where its slots begin
layout(binding = kTouchedSlotUnit) uniform usamplerBuffer
    touched_slots;  // by blade of the cell: 0, or 1 + place of its chain
layout(binding = kTouchedChainUnit) uniform samplerBuffer touched_chains;  // BladeChain, nine texels each

uint touched_slot(uint cell, uint k) {
  uint slots = texelFetch(touched_cells, int(cell)).x;
  return slots == 0u ? 0u : texelFetch(touched_slots, int(slots - 1u + k)).x;
}

// Shrunk towards its foot.
BladeChain touched_chain(uint slot, float growth) {
  int first = 9 * int(slot - 1u);
  vec4 a = texelFetch(touched_chains, first);
  vec4 b = texelFetch(touched_chains, first + 1);
  vec4 c = texelFetch(touched_chains, first + 2);
  vec4 d = texelFetch(touched_chains, first + 3);
  vec4 e = texelFetch(touched_chains, first + 4);
  vec4 f = texelFetch(touched_chains, first + 5);
  vec4 g = texelFetch(touched_chains, first + 6);
  vec4 h = texelFetch(touched_chains, first + 7);
  vec4 i = texelFetch(touched_chains, first + 8);
  BladeChain chain;
  chain.p0 = a.xyz;
  chain.p1 = a.xyz + growth * (vec3(a.w, b.xy) - a.xyz);
  chain.p2 = a.xyz + growth * (vec3(b.zw, c.x) - a.xyz);
  chain.p3 = a.xyz + growth * (c.yzw - a.xyz);
  chain.p4 = a.xyz + growth * (d.xyz - a.xyz);
  chain.m0 = growth * vec3(d.w, e.xy);
  chain.m1 = growth * vec3(e.zw, f.x);
  chain.m2 = growth * f.yzw;
  chain.m3 = growth * g.xyz;
  chain.m4 = growth * vec3(g.w, h.xy);
  chain.side = vec3(h.zw, i.x);
  return chain;
}

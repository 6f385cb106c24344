import type { Rng } from '#core/rng';

const pick = (rng: Rng, count: number): number => Math.floor(rng.unit() * count);

/** Bytes with some of them changed, removed or put in. */
export function mutatedBytes(bytes: Uint8Array, rng: Rng): Uint8Array {
  const list = Array.from(bytes);
  for (let times = 1 + pick(rng, 4); times > 0; times -= 1) {
    const at = pick(rng, list.length + 1);
    const way = rng.unit();
    if (way < 0.7) list[Math.min(at, Math.max(0, list.length - 1))] = pick(rng, 256);
    else if (way < 0.85) list.splice(at, 1 + pick(rng, 4));
    else list.splice(at, 0, ...Array.from({ length: 1 + pick(rng, 8) }, () => pick(rng, 256)));
  }
  return Uint8Array.from(list);
}

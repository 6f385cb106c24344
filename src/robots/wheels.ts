import type { Wheel } from '#world/chassis';

/** The two equal wheels of a robot whose axle goes through the origin of its frame; lengths in mm. */
export function wheelPair(trackMm: number, wheel: Omit<Wheel, 'atMm'>): readonly [left: Wheel, right: Wheel] {
  return [
    { atMm: { x: 0, y: trackMm / 2 }, ...wheel },
    { atMm: { x: 0, y: -trackMm / 2 }, ...wheel },
  ];
}

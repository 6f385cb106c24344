/** The highest level of a board's display. */
const FULL = 255;

/** The light of an ordinary room, in lx, and its level: the value of a board's sensor while nobody says otherwise. */
const ROOM = { lx: 300, level: 127 } as const;

/** Lux times level of the place where both halves of the law are equal. */
const HALF = ROOM.lx * (FULL - ROOM.level);

/**
 * The light level of a board, 0 … 255, from the illuminance in lx: 255 · E / (E + 302 lx), not rounded, 127 in an ordinary
 * room. The sensors of the robots have the same law on their own scales. See docs/hardware/light.md.
 */
export const levelOfLux = (lx: number): number => (FULL * (lx * ROOM.level)) / (lx * ROOM.level + HALF);

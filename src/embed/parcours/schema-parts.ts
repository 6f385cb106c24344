import * as v from 'valibot';

import { SPEEDS } from '#simulation/pace';

import { limits } from './limits';

/** Kinds of steps by lines. */
export const STEPS = ['over', 'into', 'out', 'back'] as const;

/** The page's colours. */
export const THEMES = ['system', 'light', 'dark'] as const;

/** A text of at most this many characters. */
export const textOf = (mostCharacters: number) => v.pipe(v.string(), v.maxLength(mostCharacters));

/** An id; the page knows which ids exist. */
export const idOf = (about: string) => v.pipe(textOf(limits.nameCharacters), v.description(about));

/** Yes or no. */
export const flag = (about: string) => v.pipe(v.boolean(), v.description(about));

/** A finite number: neither `NaN` nor infinite. */
export const numberOf = (about: string) => v.pipe(v.number(), v.finite(), v.description(about));

/** A speed. */
export const speed = v.pipe(
  v.picklist(SPEEDS),
  v.description('Simulated seconds per second; `max`: as fast as the machine can.'),
);

/** A position on the floor. */
export const poseFields = {
  xMm: numberOf('From the left edge of the arena, in mm.'),
  yMm: numberOf('From its lower edge, in mm.'),
  headingDeg: numberOf('Degrees counter-clockwise from +x.'),
};

/** The forms of a chain of lights: the order in which its wire runs. */
export const LIGHT_FORMS = ['ring', 'strip', 'matrix', 'zigzag'] as const;
export type LightForm = (typeof LIGHT_FORMS)[number];

/** The places that show it: beside the microcomputer, or on the robot in the arena. */
export const LIGHT_PLACES = ['board', 'robot'] as const;
export type LightPlace = (typeof LIGHT_PLACES)[number];

/** The choice for the chain on a pin; missing fields have their default. */
export interface LightWish {
  readonly form?: LightForm;
  readonly place?: LightPlace;
}

/** Choices by the name of the pin's wire, e.g. `P2`. */
export type LightWishes = Readonly<Record<string, LightWish>>;

/** Numbers of lights that rings usually have. */
const RING_COUNTS: readonly number[] = [8, 12, 16, 24];

/** The most likely form of a chain of this many lights. */
export function usualForm(count: number): LightForm {
  if (RING_COUNTS.includes(count)) return 'ring';
  return count === 256 ? 'zigzag' : 'strip';
}

/** Reads stored choices; invalid ones are left out. */
export function readLightWishes(value: unknown): LightWishes {
  if (typeof value !== 'object' || value === null) return {};
  return Object.fromEntries(
    Object.entries(value).flatMap(([pin, wish]: [string, unknown]) => {
      if (typeof wish !== 'object' || wish === null || !/^\w{1,20}$/.test(pin)) return [];
      const read = wish as Record<keyof LightWish, unknown>;
      const form = LIGHT_FORMS.find((it) => it === read.form);
      const place = LIGHT_PLACES.find((it) => it === read.place);
      return [[pin, { ...(form && { form }), ...(place && { place }) }] as const];
    }),
  );
}

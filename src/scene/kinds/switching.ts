/**
 * The way in which a lamp is switched on and off, or a barrier opened and closed.
 *
 * - `hand`: by a tap during the run; it begins off;
 * - `time`: seconds on and seconds off, again and again; it begins on;
 * - `radio`: the text that switches it on, and the one that switches it off, from any board; it begins off;
 * - `button`: each press on any board switches it over; it begins off;
 * - `pin`: on while this wire of the first board without a robot (or of the first one) is high.
 */
export type Switching =
  | 'hand'
  | { readonly time: readonly [on: number, off: number] }
  | { readonly radio: readonly [on: string, off: string] }
  | { readonly button: 'a' | 'b' }
  | { readonly pin: SwitchPin };

/** The wires that can switch something, as `pin0` or `P0` names them. */
export const switchPins = ['P0', 'P1', 'P2', 'P3', 'P8', 'P12', 'P13', 'P14', 'P15', 'P16'] as const;
export type SwitchPin = (typeof switchPins)[number];

/** The ways of switching, by their names in a file. */
export const switchWays = ['hand', 'time', 'radio', 'button', 'pin'] as const;
export type SwitchWay = (typeof switchWays)[number];

/** Limits of what switches. Chosen: from a short flash to a lesson, and a text that one packet takes. */
export const switchLimits = { seconds: { min: 0.1, max: 3600 }, characters: 40 } as const;

/** The way of a switching. */
export function wayOfSwitching(switching: Switching): SwitchWay {
  if (switching === 'hand') return 'hand';
  return switchWays.find((way) => way in switching) ?? 'hand';
}

/** True if a thing begins on: a lamp with the light, a barrier open. `null`: it is always on. */
export const beginsOn = (switching: Switching | null): boolean =>
  switching === null || (switching !== 'hand' && 'time' in switching);

/** A switching in the form of a file. */
export function switchingText(switching: Switching): string {
  if (switching === 'hand') return '"hand"';
  if ('time' in switching) return `{ "time": [${switching.time.join(', ')}] }`;
  if ('radio' in switching) return `{ "radio": [${switching.radio.map((text) => JSON.stringify(text)).join(', ')}] }`;
  if ('button' in switching) return `{ "button": "${switching.button}" }`;
  return `{ "pin": "${switching.pin}" }`;
}

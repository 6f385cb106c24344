/**
 * The codes of what is not the same in Parcours and in WebTigerPython: each with the values of its sentence in `words`.
 * `key` is a name in WebTigerPython's world, `place` an entry such as `Wallobjects[2]`, `value` what stands there.
 */
export const noteCodes = [
  // a world that cannot be read, or not all of it
  ...(['programDamaged', 'worldDamaged', 'worldTooLarge', 'worldUnknown', 'keys', 'keyUnread', 'moreValues'] as const),
  ...(['sizeMissing', 'sizeUnread', 'sizeLimited'] as const),
  ...(['startMissing', 'startUnread', 'startAngle', 'startMoved'] as const),
  ...(['wallsUnread', 'wallsWithoutLength', 'blocksUnread', 'blocksMovable', 'blocksAngle', 'far', 'tooMany'] as const),
  // a link that says more than program and world
  ...(['device', 'parameters', 'repeat'] as const),
  // a project that says more than a link can hold
  ...(['strokes', 'zones', 'spikes', 'movers', 'labels', 'starts', 'otherObjects'] as const),
  ...(['wallAngles', 'wallThickness', 'blockAngles', 'blockSizes', 'blockShapes', 'heights', 'editing'] as const),
  ...(['robotHeading', 'robotSize', 'robotType', 'robotAbsent', 'robotOptions', 'robotLooks'] as const),
  ...(['task', 'background', 'texts', 'devices', 'board', 'settings'] as const),
] as const;
export type NoteCode = (typeof noteCodes)[number];

/** Something that was not taken over, or not as it was. */
export interface Note {
  readonly code: NoteCode;
  /** Values for the sentence about it. */
  readonly params: Readonly<Record<string, string | number>>;
}

/** A note. */
export const note = (code: NoteCode, params: Note['params'] = {}): Note => ({ code, params });

/** Most names in one note. Chosen: a sentence that can still be read. */
const MOST_NAMES = 5;

/** Longest name that is shown whole, in characters. */
const NAME_CHARACTERS = 30;

/** Names in one text; long ones are cut, and many end in `…`. */
export function namesTogether(names: readonly string[]): string {
  const shown = names.slice(0, MOST_NAMES).map((name) => shortName(name));
  return [...shown, ...(names.length > MOST_NAMES ? ['…'] : [])].join(', ');
}

/** A name from outside that fits into a sentence. */
export const shortName = (name: string): string =>
  name.length > NAME_CHARACTERS ? `${name.slice(0, NAME_CHARACTERS)}…` : name;

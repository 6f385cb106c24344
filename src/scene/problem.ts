/** The codes of faults of a course. The web translates by this code and the problem's parameters. */
export type SceneProblemCode =
  | 'too-long'
  | 'not-json'
  | 'not-a-scene'
  | 'unknown-version'
  | 'newer-version'
  | 'missing'
  | 'wrong-type'
  | 'not-whole'
  | 'out-of-range'
  | 'too-many'
  | 'unknown-property'
  | 'unknown-value'
  | 'damaged'
  | 'not-one-line'
  | 'duplicate-id'
  | 'unknown-id'
  | 'wall-without-length'
  | 'ball-not-round'
  | 'said-twice'
  | 'polygon-crossing'
  | 'polygon-too-small'
  | 'group-of-one'
  | 'robot-outside'
  | 'robot-inside'
  | 'unknown-robot'
  | 'unknown-board';

/** One mistake in a course: its place, the value there, and what to do. */
export interface SceneProblem {
  readonly code: SceneProblemCode;
  /** Place in the file such as `objects[2].to`; empty for the file as a whole. */
  readonly path: string;
  /** The value there, shortened; empty for a missing one. */
  readonly value: string;
  /** Figures and words of the message, for translations. */
  readonly params: Readonly<Record<string, string | number>>;
  /** One or two English sentences that name place, value and remedy. */
  readonly message: string;
}

const SHOWN_CHARACTERS = 60; // chosen: fits one line of a terminal together with the message

/** A value in the form of a file, cut to a readable length; looks only two levels deep, however deep the value is. */
export function shown(value: unknown): string {
  const text = Array.isArray(value) ? shownList(value) : shownPlain(value);
  return text.length > SHOWN_CHARACTERS ? `${text.slice(0, SHOWN_CHARACTERS)}…` : text;
}

function shownList(list: readonly unknown[]): string {
  const first = list.slice(0, 4).map((entry) => (Array.isArray(entry) ? '[…]' : shownPlain(entry)));
  return list.length > 4 ? `[${first.join(', ')}, … ${list.length} entries]` : `[${first.join(', ')}]`;
}

function shownPlain(value: unknown): string {
  if (typeof value === 'string') return JSON.stringify(value.slice(0, SHOWN_CHARACTERS));
  if (typeof value === 'object' && value !== null) return `{ ${Object.keys(value).slice(0, 5).join(', ')} }`;
  return String(value);
}

/**
 * The problem of a file of a version that this app does not read.
 *
 * @param what name of the file in the message: `Project`, `Series`
 * @param known the newest version that is read
 */
export function versionProblem(
  what: string,
  version: unknown,
  known: number,
): SceneProblem & { readonly code: 'newer-version' | 'unknown-version' } {
  const isNewer = typeof version === 'number' && Number.isInteger(version) && version > known;
  const params = { version: typeof version === 'number' ? version : shown(version).slice(0, 20), known };
  const message = isNewer
    ? `${what} version ${String(version)} is newer than this app (${String(known)}). Reload the page to update.`
    : `${what} version ${String(params.version)} is unknown; this app reads version ${String(known)}.`;
  return {
    code: isNewer ? 'newer-version' : 'unknown-version',
    path: 'version',
    value: shown(version),
    params,
    message,
  };
}

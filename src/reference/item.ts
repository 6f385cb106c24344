import type { Feature } from '#core/board-api';
import type { EntryKind, Limits } from './types';

/** The editor's information on a name. */
export interface Item {
  readonly label: string;
  /** `variable` and `parameter` are the pupil's own names. */
  readonly kind: EntryKind | 'variable' | 'parameter';
  /** Signatures, such as `(x: int, y: int) -> int`. */
  readonly calls: readonly string[];
  /** Its type: `int`, `Image`. */
  readonly type: string | null;
  /** Key of its words; `null` if it has none. */
  readonly text: string | null;
  /** The docstring of the pupil's function or class. */
  readonly own: string | null;
  /** The module or file it belongs to: `microbit.display`, or a file's name; `null` for names of the program itself. */
  readonly home: string | null;
  /** Why the board's firmware lacks this name: the newer feature that has it, or `absent`; `null`: it has the name. */
  readonly missing: Feature | 'absent' | null;
  /** Sensible values of its parameters, by their names. */
  readonly limits: Limits;
}

/** Makes an item; what is left out is empty. */
export function itemOf(parts: Partial<Item> & Pick<Item, 'label' | 'kind'>): Item {
  return { calls: [], type: null, text: null, own: null, home: null, missing: null, limits: {}, ...parts };
}

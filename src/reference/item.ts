import type { Feature } from '#core/board-api';
import type { EntryKind } from './types';

/** What the editor shows about a name. */
export interface Item {
  readonly label: string;
  /** `variable` and `parameter`: names of the pupil's own. */
  readonly kind: EntryKind | 'variable' | 'parameter';
  /** `(x: int, y: int) -> int`, one for each way of calling it. */
  readonly calls: readonly string[];
  /** What kind of value it is: `int`, `Image`. */
  readonly type: string | null;
  /** Under which name its words stand; `null` when there are none. */
  readonly text: string | null;
  /** The pupil's own words: the text at the beginning of a function or class. */
  readonly own: string | null;
  /** Where it belongs: `microbit.display`, or a file's name; `null` for names of the program itself. */
  readonly home: string | null;
  /** The board's firmware is older than this name, or has never had it. */
  readonly missing: Feature | 'absent' | null;
}

/** An item; whatever is not given is empty. */
export function itemOf(parts: Partial<Item> & Pick<Item, 'label' | 'kind'>): Item {
  return { calls: [], type: null, text: null, own: null, home: null, missing: null, ...parts };
}

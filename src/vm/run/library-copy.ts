import type { Board } from '#board/board';
import type { Scope } from '../debug/inspected';
import { isSame } from '#core/same';
import type { Agreed } from './engine';
import type { Firmware } from './firmware';
import type { Memory } from './values';
import { changeSince, type StateChange, type VmState } from './vm-state';

/**
 * The facts that loading the library depends on: it asks the board, and which files there are. Neither time nor
 * chance matters.
 */
export interface LoadedFor {
  readonly module: WebAssembly.Module;
  readonly board: Pick<Board, 'type' | 'firmware'>;
  readonly fileNames: readonly string[];
}

/** Everything that the host received while the library was loaded. */
interface Heard {
  readonly agreed: Agreed;
  readonly scopes: ReadonlyMap<number, Scope>;
}

/** The effect of loading the library on a VM that was just started. */
export interface LibraryCopy extends Heard {
  readonly change: StateChange;
}

/** Most copies of a module, of some 200 kB each. Chosen: boards and firmwares of a class, with main.py alone. */
const MOST_COPIES = 8;

interface Kept {
  readonly of: LoadedFor;
  readonly copy: LibraryCopy;
}

/** The newest last. */
const copies = new WeakMap<WebAssembly.Module, readonly Kept[]>();

/** The copy that suits a VM, or `null`. */
export function findCopy(wanted: LoadedFor): LibraryCopy | null {
  const kept = copies.get(wanted.module)?.find(({ of }) => suits(of, wanted));
  return kept?.copy ?? null;
}

const suits = (one: LoadedFor, other: LoadedFor): boolean =>
  one.board.type === other.board.type &&
  one.board.firmware === other.board.firmware &&
  isSame(one.fileNames, other.fileNames);

/** Stores all that has changed in a VM since `before`. When there are too many copies, the oldest one is dropped. */
export function keepCopy(of: LoadedFor, before: VmState, firmware: Firmware, memory: Memory, heard: Heard): void {
  const change = changeSince(before, firmware, memory);
  const copy: LibraryCopy = { agreed: heard.agreed, scopes: new Map(heard.scopes), change };
  const { type, firmware: ofBoard } = of.board; // the board itself would keep its run
  const kept = { of: { ...of, board: { type, firmware: ofBoard } }, copy };
  copies.set(of.module, [...(copies.get(of.module) ?? []).slice(1 - MOST_COPIES), kept]);
}

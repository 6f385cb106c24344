import { expect } from 'vitest';
import { Board } from '#board/board';
import type { BoardType, FirmwareType } from '#board/boards/board-type';
import { Clock } from '#core/clock';
import { ConsolePort } from '../console-port';
import { Files } from '../files';
import { Repl } from '../repl';
import { Report } from '../report';
import { Session } from '../session';
import { stateOf, type VmState } from '../vm-state';
import { firmware } from './run-program';

/** MicroPython from power-up, with its surroundings. */
export interface Made {
  readonly session: Session;
  readonly board: Board;
  readonly clock: Clock;
  readonly printed: () => string;
  /** The calls of `_hal` while it was made, if somebody listened. */
  readonly calls: readonly string[];
}

/** Texts by file name. */
export type Texts = Readonly<Record<string, string>>;

/**
 * Switches a board on.
 *
 * @param isObserved whether somebody hears of all calls: then the library is loaded and not copied
 */
export function made(
  type: BoardType,
  ofBoard: FirmwareType,
  given: Texts,
  isObserved: boolean,
  clock = new Clock(),
): Made {
  const board = new Board(type, clock, ofBoard);
  const calls: string[] = [];
  let printed = '';
  const write = (text: string): void => void (printed += text);
  const observer = { before: () => undefined, after: (call: string) => void calls.push(call), print: () => undefined };
  const setup = { firmware, board, clock, files: given, libraries: {}, seed: 7, write };
  const files = new Files(given);
  const report = new Report(write, (name) => new TextDecoder().decode(files.find(name)?.bytes), null);
  const port = new ConsolePort((bytes) => report.write(bytes));
  const repl = new Repl(port, ofBoard.banner, false);
  const ports = { files, port, report, repl, hold: { watch: null, isHeld: false }, startUs: 0 };
  const session = new Session({ ...setup, ...(isObserved && { observer }) }, ports);
  return { session, board, clock, printed: () => printed, calls: [...calls] };
}

/** All of its VM's state. */
export const stateIn = ({ session }: Made): VmState => stateOf(session['firmware'], session['memory']);

/** Expects two VMs in the same state. */
export function expectSame(one: Made, other: Made): void {
  const [a, b] = [stateIn(one), stateIn(other)];
  expect(Buffer.compare(a.bytes, b.bytes), 'memory').toBe(0);
  expect(a.globals).toEqual(b.globals);
}

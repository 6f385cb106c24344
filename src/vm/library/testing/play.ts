import type { BoardType, FirmwareType } from '#board/boards/board-type';
import { calliopeMini3 } from '#board/boards/calliope-mini-3';
import { microbitV2 } from '#board/boards/microbit-v2';
import { createBench, type Bench } from '#board/testing/bench';
import { firmware } from '../../run/testing/run-program';
import { createVm, type Vm, type VmEnd } from '../../run/vm';

/** A program that runs on a board on the table. */
export interface Play {
  readonly bench: Bench;
  readonly vm: Vm;
  /** Everything printed so far. Lines end with a newline, whatever the console ends them with. */
  readonly printed: () => string;
  /** Lets simulated time pass until this many ms after the start, while the program runs. */
  readonly until: (ms: number) => Play;
  readonly ended: () => VmEnd | null;
}

/** The board and its firmware: a micro:bit V2 with its default firmware unless given otherwise. */
export interface Device {
  readonly type?: BoardType;
  readonly firmware?: FirmwareType | undefined;
}

/** Prepares a program (main.py) with further files; `setUp` connects what the program will meet. */
export function play(
  program: string,
  files: Readonly<Record<string, string>> = {},
  setUp: (bench: Bench) => void = () => undefined,
  device: Device = {},
): Play {
  const bench = createBench(device.type, device.firmware);
  setUp(bench);
  let text = '';
  const vm = createVm({
    firmware,
    board: bench.board,
    clock: bench.clock,
    files: { ...files, 'main.py': program },
    libraries: {},
    seed: 1,
    write: (part) => {
      text += part;
    },
  });
  const self: Play = {
    bench,
    vm,
    printed: () => text.replace(/\r/g, ''),
    until: (ms) => {
      vm.resume(ms * 1000);
      return self;
    },
    ended: () => vm.ended,
  };
  return self;
}

/** Devices with a firmware newer than v2.1.2. */
export const LATER: readonly Device[] = [{ firmware: microbitV2.firmwares[1] }, { type: calliopeMini3 }];

const LIMIT_MS = 60_000;

/**
 * Prepended to programs of `linesOf`: err(f, …) prints the error that a call raises, took(f, …) its time in ms, and
 * exact(f, …) its time from a 6 ms tick on, which is exact: it begins and ends in the ms of a tick.
 */
const PRELUDE = `
def err(f, *a, **k):
    try:
        print('no error:', f(*a, **k))
    except BaseException as e:
        print(type(e).__name__ + ':', e)
def took(f, *a, **k):
    t = running_time()
    f(*a, **k)
    return running_time() - t
def exact(f, *a, **k):
    while running_time() % 6:
        pass
    return took(f, *a, **k)
`;

/** Runs a program that imports microbit to its end, within a minute, and gives the lines that it printed. */
export function linesOf(
  program: string,
  files: Readonly<Record<string, string>> = {},
  setUp: (bench: Bench) => void = () => undefined,
  device: Device = {},
): string[] {
  const run = play(`from microbit import *\n${PRELUDE}${program}`, files, setUp, device).until(LIMIT_MS);
  if (run.ended() === null) throw new Error(`Not at its end after ${LIMIT_MS} ms. Printed:\n${run.printed()}`);
  return run.printed().trimEnd().split('\n');
}

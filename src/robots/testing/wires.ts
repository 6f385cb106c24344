import { createBench } from '#board/testing/bench';
import type { I2cTarget } from '#board/wires/i2c-bus';
import type { Board } from '#board/board';
import type { Clock } from '#core/clock';
import { createVm } from '#vm/run/vm';
import type { RobotBuild } from '../robot';

/** The surroundings of a library in a test. */
export interface WiresSetup {
  readonly build: RobotBuild;
  readonly firmware: WebAssembly.Module;
  /** Devices that answer at each address; the bytes sent there are recorded. */
  readonly chips: Readonly<Record<number, I2cTarget>>;
  /** Connects things to pins before the program starts. */
  readonly connect?: (board: Board, clock: Clock) => void;
  /** @default 5000 */
  readonly forMs?: number;
}

/** The program's actions on the wires. */
export interface WiresRun {
  /** The bytes of each write on the bus, without pure address writes. */
  readonly messages: readonly (readonly number[])[];
  readonly lines: readonly string[];
  /** `Type: message` of the exception that ended it, or `null`. */
  readonly exception: string | null;
  readonly hasEnded: boolean;
  /** Every PWM signal that started on a pin, as `P0: 20000 µs, 77/1024`. */
  readonly pwm: readonly string[];
  /** Pitches at the buzzer in Hz, 0 = silence. */
  readonly tones: readonly number[];
  readonly board: Board;
}

/** Runs a program with a robot's libraries on a bare board and listens to the wires. */
export function runOnWires(program: string, { build, firmware, chips, connect, forMs = 5000 }: WiresSetup): WiresRun {
  const { board, clock } = createBench();
  const messages: number[][] = [];
  for (const [address, chip] of Object.entries(chips)) {
    const write = (bytes: Uint8Array): void => {
      messages.push([...bytes]);
      chip.write(bytes);
    };
    board.i2c.attach(Number(address), { write, read: (count) => chip.read(count) });
  }
  connect?.(board, clock);
  const pwm: string[] = [];
  const tones: number[] = [];
  for (const name of ['P0', 'P1', 'P2']) {
    board.wire(name).onPwm((signal) => {
      if (signal) pwm.push(`${name}: ${signal.periodUs} µs, ${Math.round(signal.dutyFraction * 1024)}/1024`);
      if (name === 'P0') tones.push(signal ? Math.round(1_000_000 / signal.periodUs) : 0);
    });
  }
  let output = '';
  const write = (text: string): void => void (output += text);
  const files = { 'main.py': program };
  const vm = createVm({ firmware, board, clock, files, libraries: build.libraries, seed: 1, write });
  vm.resume(forMs * 1000);
  const exception = vm.ended?.exception ?? null;
  return {
    messages,
    lines: output.split(/\r?\n/).filter((line) => line !== ''),
    exception: exception && `${exception.type}: ${exception.message}`,
    hasEnded: vm.ended !== null,
    pwm,
    tones,
    board,
  };
}

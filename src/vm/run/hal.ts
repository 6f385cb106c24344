import type { Board } from '#board/board';
import type { Rng } from '#core/rng';
import type { ConsolePort } from './console-port';
import type { Files } from './files';
import { createConsoleCalls } from './hal-console';
import { createDeviceCalls } from './hal-device';
import { createDisplayCalls } from './hal-display';
import { createFileCalls } from './hal-files';
import { createI2cCalls } from './hal-i2c';
import { createMusicCalls } from './hal-music';
import { createPinCalls } from './hal-pins';
import { createTimeCalls } from './hal-time';
import type { Machine, SyscallTable } from './syscall';

/**
 * All functions of the module `_hal` that reach the board. What only the VM can do it adds itself:
 * on_callback(address of the dispatcher), throw(address of an exception), panic(number), reset().
 *
 * @param rng chance for what differs from board to board
 */
export function createHal(machine: Machine, board: Board, files: Files, port: ConsolePort, rng: Rng): SyscallTable {
  return {
    ...createPinCalls(machine, board),
    ...createI2cCalls(machine, board),
    ...createDisplayCalls(machine, board),
    ...createMusicCalls(machine, board),
    ...createTimeCalls(machine, board),
    ...createFileCalls(machine, files, board.type.costsUs.callUs),
    ...createConsoleCalls(machine, board, port),
    ...createDeviceCalls(machine, board, rng),
  };
}

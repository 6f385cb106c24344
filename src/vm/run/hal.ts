import type { Board } from '#board/board';
import type { Rng } from '#core/rng';
import type { ConsolePort } from './console-port';
import type { Files } from './files';
import { createBoardCalls } from './hal-board';
import { createConsoleCalls } from './hal-console';
import { createDeviceCalls } from './hal-device';
import { createDisplayCalls } from './hal-display';
import { createFileCalls } from './hal-files';
import { createI2cCalls } from './hal-i2c';
import { createLogCalls } from './hal-log';
import { createMusicCalls } from './hal-music';
import { createPinCalls } from './hal-pins';
import { createPowerCalls } from './hal-power';
import { createRadioCalls } from './hal-radio';
import { createSenseCalls } from './hal-senses';
import { createSoundCalls } from './hal-sound';
import { createSpiCalls } from './hal-spi';
import { createTimeCalls } from './hal-time';
import { createUartCalls } from './hal-uart';
import type { Machine, SyscallTable } from './syscall';

/**
 * All functions of the module `_hal` that reach the board. What only the VM can do it adds itself (session.ts).
 *
 * @param rng chance for what differs from board to board
 */
export function createHal(machine: Machine, board: Board, files: Files, port: ConsolePort, rng: Rng): SyscallTable {
  return {
    ...createBoardCalls(board),
    ...createPinCalls(machine, board),
    ...createI2cCalls(machine, board),
    ...createSpiCalls(machine, board),
    ...createUartCalls(machine, board, port),
    ...createDisplayCalls(machine, board),
    ...createMusicCalls(machine, board),
    ...createSoundCalls(machine, board, rng),
    ...createTimeCalls(machine, board),
    ...createFileCalls(machine, files, board),
    ...createConsoleCalls(port),
    ...createDeviceCalls(machine, board, rng),
    ...createSenseCalls(machine, board),
    ...createRadioCalls(machine, board),
    ...createLogCalls(machine, board, port),
    ...createPowerCalls(machine, board),
  };
}

import type { Board } from '#board/board';
import type { Rng } from '#core/rng';
import type { ConsolePort } from '../console-port';
import type { Files } from '../files';
import { createBoardCalls } from './board';
import { createConsoleCalls } from './console';
import { createDeviceCalls } from './device';
import { createDisplayCalls } from './display';
import { createFileCalls } from './files';
import { createI2cCalls } from './i2c';
import { createImageCalls } from './image';
import { createLogCalls } from './log';
import { createMusicCalls } from './music';
import { createPinCalls } from './pins';
import { createPowerCalls } from './power';
import { createRadioCalls } from './radio';
import { createSenseCalls } from './senses';
import { createSoundCalls } from './sound';
import { createSpiCalls } from './spi';
import { createTimeCalls } from './time';
import { createUartCalls } from './uart';
import type { Machine, SyscallTable } from '../syscall';

/**
 * All functions of the module `_hal` that reach the board. The session adds those that only the VM can do (session.ts).
 *
 * @param rng random numbers for what differs from board to board
 */
export function createHal(machine: Machine, board: Board, files: Files, port: ConsolePort, rng: Rng): SyscallTable {
  return {
    ...createBoardCalls(board),
    ...createPinCalls(machine, board),
    ...createI2cCalls(machine, board),
    ...createSpiCalls(machine, board),
    ...createUartCalls(machine, board, port),
    ...createDisplayCalls(machine, board),
    ...createImageCalls(machine, board),
    ...createMusicCalls(machine, board, port),
    ...createSoundCalls(machine, board, rng),
    ...createTimeCalls(machine, board),
    ...createFileCalls(machine, files, board),
    ...createConsoleCalls(port),
    ...createDeviceCalls(machine, board, rng),
    ...createSenseCalls(machine, board),
    ...createRadioCalls(machine, board),
    ...createLogCalls(machine, board, port),
    ...createPowerCalls(machine, board, port),
  };
}

import { part } from '../../kit/part';
import type { DebugSlot } from './debug-slot';

/** Break points, stops and variables of programs. */
export interface DebugParts {
  readonly slot: DebugSlot;
}

export const [provideDebug, useDebug] = part<DebugParts>('debug');

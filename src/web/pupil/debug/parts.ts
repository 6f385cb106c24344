import { part } from '../../kit/part';
import type { DebugSlot } from './debug-slot';

/** Where a program stops, and what its variables are then. */
export interface DebugParts {
  readonly slot: DebugSlot;
}

export const [provideDebug, useDebug] = part<DebugParts>('debug');

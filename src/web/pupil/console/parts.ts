import type { ConsoleModel } from './console-model';
import type { Jump } from './jump';
import { part } from '../../kit/part';

/** The console, and the way from its errors to the line. */
export interface ConsoleParts {
  readonly console: ConsoleModel;
  readonly jump: Jump;
}

export const [provideConsole, useConsole] = part<ConsoleParts>('console');

import type { DataLogModel } from './data-log-model';
import type { Hand } from './hand';
import type { RadioModel } from './radio-model';
import type { RunModel } from './run-model';
import type { SensorsModel } from './sensors-model';
import type { SoundPlayer } from './sound/sound-player';
import { part } from '../../kit/part';

/** The run, its inputs and its outputs. */
export interface RunParts {
  readonly run: RunModel;
  readonly sensors: SensorsModel;
  readonly radio: RadioModel;
  readonly dataLog: DataLogModel;
  readonly sound: SoundPlayer;
  readonly hand: Hand;
}

export const [provideRun, useRun] = part<RunParts>('run');

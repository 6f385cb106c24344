import type { ShallowRef } from 'vue';

import type { Scene } from '#scene/scene';

import type { DataLogModel } from './data-log-model';
import type { Hand } from './hand';
import type { RadioModel } from './radio-model';
import type { RunListener, RunModel } from './run-model';
import type { SensorsModel } from './sensors-model';
import type { SoundPlayer } from './sound/sound-player';
import { part } from '../../kit/part';

/** The run, its inputs and its outputs. */
export interface RunParts {
  readonly run: RunModel;
  /** The course that the run was given; `null`: everything is at the start. */
  readonly runStart: ShallowRef<Scene | null>;
  /** The rooms that take note of runs: each adds itself when the page is made. */
  readonly listeners: RunListener[];
  readonly sensors: SensorsModel;
  readonly radio: RadioModel;
  readonly dataLog: DataLogModel;
  readonly sound: SoundPlayer;
  readonly hand: Hand;
}

export const [provideRun, useRun] = part<RunParts>('run');

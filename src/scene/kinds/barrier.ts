import { pair, property } from '../json-text';
import { sceneDefaults, type Barrier } from '../scene';
import { switchingText } from './switching';
import { standing, type SceneKind } from './kind';
import { wallOutline } from './wall';

/** Barriers; where they are is told as if they were closed. */
export const barrier: SceneKind<Barrier> = {
  name: 'barrier',
  write: ({ from, to, thickness, height, opens }) => [
    `"from": ${pair(from)}`,
    `"to": ${pair(to)}`,
    ...property('thickness', thickness, sceneDefaults.thickness),
    ...property('height', height ?? null, null),
    ...(opens === 'hand' ? [] : [`"opens": ${switchingText(opens)}`]),
  ],
  ...standing<Barrier>((barrier) => [wallOutline(barrier)]),
};

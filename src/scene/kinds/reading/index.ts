import type { SceneObject } from '../../scene';
import { block, fixedBlock, spikes } from './block';
import type { KindReader } from './kind-reader';
import { barrier } from './barrier';
import { label } from './label';
import { lamp } from './lamp';
import { tag } from './tag';
import { tunnel } from './tunnel';
import { mover } from './mover';
import { paper } from './paper';
import { start } from './start';
import { stroke } from './stroke';
import { wall } from './wall';
import { checkpoint, forbidden, target } from './zone';

/** How each kind of object is read. Problems name the types in this order. */
export const kindReaders: Readonly<Record<SceneObject['type'], KindReader>> = {
  wall,
  block,
  'fixed-block': fixedBlock,
  stroke,
  target,
  checkpoint,
  forbidden,
  paper,
  spikes,
  mover,
  lamp,
  barrier,
  tunnel,
  tag,
  label,
  start,
};

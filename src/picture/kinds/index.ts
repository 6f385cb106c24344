import type { SceneObject } from '#scene/scene';

import { block, fixedBlock } from './block';
import type { PictureKind } from './kind';
import { barrier } from './barrier';
import { label } from './label';
import { lamp } from './lamp';
import { tag } from './tag';
import { tunnel } from './tunnel';
import { mover } from './mover';
import { paper } from './paper';
import { spikes } from './spikes';
import { start } from './start';
import { stroke } from './stroke';
import { wall } from './wall';
import { zone } from './zone';

/** Every kind of object by its type. */
export const pictureKinds: Readonly<Record<SceneObject['type'], PictureKind>> = {
  wall,
  block,
  'fixed-block': fixedBlock,
  stroke,
  target: zone,
  checkpoint: zone,
  forbidden: zone,
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

/** The kind of an object. */
export const kindOf = ({ type }: SceneObject): PictureKind => pictureKinds[type];

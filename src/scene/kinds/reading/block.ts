import { sceneLimits, type Block, type Spikes } from '../../scene';
import type { KindReader } from './kind-reader';
import { readBody, readHeight, readPaint, type Unread } from './unread';

const properties = ['at', 'size', 'angle', 'round', 'corners', 'height'];

const readBlock = (given: Unread) => ({ ...readBody(given), ...readHeight(given), ...readPaint(given) });

export const block: KindReader<Block> = {
  properties: [...properties, 'color', 'infrared', 'mass', 'friction', 'rolls'],
  read(given) {
    const body = readBlock(given);
    return { type: 'block', ...body, ...readMotion(given, body.round === true) };
  },
};

/** How a block moves when it is pushed; what is left out stays left out. */
function readMotion({ reader, at }: Unread, isRound: boolean): Pick<Block, 'mass' | 'friction' | 'rolls'> {
  const [mass, massPath] = at('mass');
  const [friction, frictionPath] = at('friction');
  const [rolls, rollsPath] = at('rolls');
  const isBall = reader.flag(rolls, rollsPath, false);
  if (isBall && !isRound)
    reader.report('ball-not-round', rollsPath, rolls, 'only what is round rolls. Add "round": true, or leave this out.'); // prettier-ignore
  return {
    ...(mass === undefined ? {} : { mass: reader.number(mass, massPath, sceneLimits.massG) }),
    ...(friction === undefined ? {} : { friction: reader.number(friction, frictionPath, sceneLimits.friction) }),
    ...(isBall ? { rolls: true } : {}),
  };
}

export const fixedBlock: KindReader<Block> = {
  properties: [...properties, 'color', 'infrared'],
  read: (given) => ({ type: 'fixed-block', ...readBlock(given) }),
};
export const spikes: KindReader<Spikes> = {
  properties,
  read: (given) => ({ type: 'spikes', ...readBody(given), ...readHeight(given) }),
};

import { paintColors } from '../../paint/paint';
import type { Range } from '../../reader';
import { sceneDefaults, sceneLimits, type Zone } from '../../scene';
import type { KindReader } from './kind-reader';
import { readPaint, readShape, type Unread } from './unread';

const NONE: Range = { min: 0, max: 0 };

function zoneReader(type: Zone['type']): KindReader<Zone> {
  const isNumbered = type === 'checkpoint';
  const numbers = isNumbered ? sceneLimits.checkpoint : NONE;
  const blocks = type === 'target' ? sceneLimits.blocks : NONE;
  return {
    properties: [
      ...['at', 'size', 'angle', 'round', 'corners', 'number', 'blocks', 'color', 'infrared'],
      ...(type === 'target' ? ['blockColor'] : []),
    ],
    read: (given) => ({
      type,
      ...readShape(given),
      round: given.reader.flag(...given.at('round'), sceneDefaults.round),
      number: given.reader.whole(...given.at('number'), numbers, isNumbered ? undefined : 0),
      blocks: given.reader.whole(...given.at('blocks'), blocks, sceneDefaults.blocks),
      ...readBlockColor(given),
      ...readPaint(given),
    }),
  };
}

/** The colour of the blocks that a target wants. */
function readBlockColor({ reader, at }: Unread): Pick<Zone, 'blockColor'> {
  const [color, path] = at('blockColor');
  return color === undefined ? {} : { blockColor: reader.word(color, path, paintColors, 'red') };
}

export const target = zoneReader('target');
export const checkpoint = zoneReader('checkpoint');
export const forbidden = zoneReader('forbidden');

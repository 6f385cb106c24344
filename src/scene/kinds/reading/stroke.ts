import { sceneDefaults, sceneLimits, type Stroke } from '../../scene';
import type { KindReader } from './kind-reader';
import { readId, readPaint } from './unread';

export const stroke: KindReader<Stroke> = {
  properties: ['points', 'width', 'color', 'infrared'],
  read(given) {
    const { reader, at, pointsLeft } = given;
    const [value, path] = at('points');
    const points = reader.list(value, path, { min: 1, max: pointsLeft });
    return {
      type: 'stroke',
      id: readId(given),
      points: points.map((point, index) => reader.point(point, `${path}[${index}]`, sceneLimits.placeMm)),
      width: reader.whole(...at('width'), sceneLimits.widthMm, sceneDefaults.width),
      color: sceneDefaults.color,
      ...readPaint(given),
    };
  },
};

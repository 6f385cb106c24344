import { sceneDefaults, type Paper } from '../../scene';
import type { KindReader } from './kind-reader';
import { readBody, readPaint } from './unread';

export const paper: KindReader<Paper> = {
  properties: ['at', 'size', 'angle', 'round', 'corners', 'color', 'infrared'],
  read: (given) => ({ type: 'paper', ...readBody(given), color: sceneDefaults.paper, ...readPaint(given) }),
};

import type { Tunnel } from '../../scene';
import type { KindReader } from './kind-reader';
import { readBody } from './unread';

export const tunnel: KindReader<Tunnel> = {
  properties: ['at', 'size', 'angle', 'round', 'corners'],
  read: (given) => ({ type: 'tunnel', ...readBody(given) }),
};

import type { Barrier } from '../../scene';
import type { KindReader } from './kind-reader';
import { readSwitching } from './switching';
import { readHeight } from './unread';
import { readLine } from './wall';

/** Reads barriers, of which as of walls none is without length. */
export const barrier: KindReader<Barrier> = {
  properties: ['from', 'to', 'thickness', 'height', 'opens'],
  read(given) {
    const [opens, path] = given.at('opens');
    return {
      type: 'barrier',
      ...readLine(given, 'barrier'),
      ...readHeight(given),
      opens: opens === undefined ? 'hand' : readSwitching(opens, path, given.reader),
    };
  },
};

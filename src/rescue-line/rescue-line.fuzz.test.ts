import { expect, it } from 'vitest';
import { createRng } from '#core/rng';
import { fuzzRuns } from '#core/testing/fuzz-runs';
import { parseScene } from '#scene/parse';
import { serializeScene } from '#scene/serialize';
import { mutatedTree } from '#scene/testing/mutate';
import { courseOfMap } from './course-of-map';
import { readMap } from './read-map';
import { demoMap, mapFile, straight, tileOf } from './testing/maps';

const crossing = tileOf('tile-30', 90, { left: 'top', right: 'left', top: 'left', bottom: 'top' }, { type: { intersections: 1 } }); // prettier-ignore
const withZone = mapFile(
  { '0,0,0': straight(), '1,0,0': crossing, '2,0,0': tileOf('ev2', 0, {}), '2,1,0': straight(90) },
  { startTile2: { x: 2, y: 1, z: 0 } },
);

it(
  `randomly changed maps make a course that can be kept, or are told what is wrong (${String(fuzzRuns)} maps)`,
  () => {
    const counts = { courses: 0, problems: 0 };
    for (let seed = 1; seed <= fuzzRuns; seed += 1) {
      const read = readMap(mutatedTree(seed % 2 === 0 ? demoMap() : withZone, createRng(seed), false));
      if ('problem' in read) {
        counts.problems += 1;
        expect(read.problem, `seed ${String(seed)}`).not.toBe('');
        continue;
      }
      counts.courses += 1;
      const { scene } = courseOfMap(read.map);
      expect(parseScene(serializeScene(scene)), `seed ${String(seed)}`).toEqual({ scene });
    }
    for (const count of [counts.courses, counts.problems]) expect(count).toBeGreaterThan(fuzzRuns / 100);
  },
  60_000 + 20 * fuzzRuns,
);

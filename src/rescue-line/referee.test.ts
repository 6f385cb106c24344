import { describe, expect, it } from 'vitest';
import type { Pose, Vec } from '#core/geometry';
import type { LeagueRules } from '#scene/league/league';
import { courseOfMap } from './course-of-map';
import { readMap } from './read-map';
import { Referee } from './referee';
import { demoMap, exit, mapFile, straight, tileOf } from './testing/maps';

const courseOf = (file: unknown, rules?: LeagueRules) => {
  const read = readMap(file);
  return 'map' in read ? courseOfMap(read.map, rules).scene : expect.fail(read.problem);
};

/** A robot of 80 mm, put from place to place. */
function run(file: unknown, rules?: LeagueRules) {
  const scene = courseOf(file, rules);
  const referee = new Referee(scene.league!, scene.objects);
  let timeUs = 0;
  const look = ({ x, y }: Vec): Pose | null => {
    const square = [40, -40].flatMap((dx) => [dx, -dx].map((dy) => ({ x: x + dx, y: y + dy })));
    timeUs += 4_000;
    const pose = { xMm: x, yMm: y, headingRad: 0 };
    return referee.look({ pose, middle: { x, y }, body: () => [square], reachMm: 60 }, timeUs);
  };
  const { tiles } = scene.league!;
  const along = (heading: number): readonly number[] =>
    [
      [1, 0],
      [0, 1],
      [-1, 0],
      [0, -1],
    ][heading / 90]!;
  /** The middle of the line on a tile: that of a bend lies nearer to its corner. */
  const tile = (index: number): Vec => {
    const [out, into] = [along(tiles[index]!.heading), along((tiles[index - 1] ?? tiles[index]!).heading)];
    const [x, y] = tiles[index]!.at;
    return { x: x + 44 * (out[0]! - into[0]!), y: y + 44 * (out[1]! - into[1]!) };
  };
  return {
    referee,
    look,
    /** Drives over the tiles from one to another. */
    drive: (from: number, to: number): void => {
      for (let index = from; index <= to; index++) expect(look(tile(index))).toBeNull();
    },
    stand: (index: number, seconds: number): void => {
      for (let step = 0; step <= seconds * 250; step++) look(tile(index));
    },
    score: () => referee.points().score,
    lines: () => referee.points().lines.map(({ what, points, state }) => `${what} ${String(points)} ${state}`),
  };
}

describe('the rules of 2025', () => {
  it('give 125 points for a perfect run over seven tiles', () => {
    const { drive, stand, score, lines, referee } = run(demoMap());
    expect(score()).toBe(5);
    drive(0, 2);
    expect(score()).toBe(15);
    drive(3, 6);
    expect(score()).toBe(50);
    stand(6, 4.9);
    expect(referee.isDone).toBe(false);
    stand(6, 0.2);
    expect(referee.isDone).toBe(true);
    expect(lines()).toEqual(['start 5 earned', 'gap 10 earned', 'tiles 15 earned', 'obstacle 20 earned', 'tiles 15 earned', 'exit 60 earned']); // prettier-ignore
    expect(score()).toBe(125);
  });

  it('give 114 with a lack of progress before the checkpoint, and put the robot back to the start', () => {
    const { drive, stand, score, look, referee } = run(demoMap());
    drive(0, 2);
    expect(look({ x: 450, y: 450 })).toBeNull(); // a tile without a line: it may still come back
    expect(look({ x: 150, y: 450 })).toEqual({ xMm: 150, yMm: 750, headingRad: 0 });
    expect(referee.points()).toMatchObject({ lacks: 1, section: 1, attempt: 2, tile: 0 });
    drive(0, 6);
    stand(6, 5);
    expect(score()).toBe(114);
  });

  it('begin anew at the last checkpoint, in the direction of the way', () => {
    const { drive, look, referee } = run(demoMap());
    drive(0, 4);
    expect(look({ x: 150, y: 750 })).toEqual({ xMm: 750, yMm: 450, headingRad: -Math.PI / 2 + 2 * Math.PI });
    expect(referee.points()).toMatchObject({ section: 2, attempt: 2, tile: 3 });
  });

  it('go on from the next checkpoint after three failed tries; the section brings nothing more', () => {
    const { drive, look, referee, lines } = run(demoMap());
    drive(0, 2);
    for (let failed = 0; failed < 3; failed++) look({ x: 150, y: 150 });
    expect(referee.points()).toMatchObject({ lacks: 3, section: 2, attempt: 1, tile: 3, score: 15 });
    expect(lines()).toContain('tiles 0 missed');
    expect(lines()).toContain('gap 10 earned');
  });

  it('count a call of the captain like any other lack', () => {
    const { drive, referee } = run(demoMap());
    drive(0, 1);
    expect(referee.lack()).toEqual({ xMm: 150, yMm: 750, headingRad: 0 });
    expect(referee.points().lacks).toBe(1);
  });
});

describe('a lack of progress', () => {
  it('is to leave the next tile without having found its line', () => {
    const { drive, look } = run(demoMap());
    drive(0, 1);
    expect(look({ x: 850, y: 850 })).toBeNull(); // on the bend’s tile, beside its line
    expect(look({ x: 850, y: 550 })).not.toBeNull();
  });

  it('is to come to a line that is not next, though not while an obstacle is driven around', () => {
    const { drive, look } = run(demoMap());
    drive(0, 2);
    expect(look({ x: 450, y: 150 })).not.toBeNull();
    const other = run(demoMap());
    other.drive(0, 5);
    expect(other.look({ x: 450, y: 450 })).toBeNull();
    expect(other.look({ x: 150, y: 150 })).toBeNull();
    expect(other.referee.points()).toMatchObject({ lacks: 0, tile: 6 });
  });

  it('is not to roll back a little', () => {
    const { drive, look, referee } = run(demoMap());
    drive(0, 2);
    expect(look({ x: 450, y: 750 })).toBeNull();
    expect(referee.points()).toMatchObject({ lacks: 0, tile: 2 });
  });
});

describe('the entry league of 2026', () => {
  it('gives nothing for the start, 10 for an obstacle and nothing for the end', () => {
    const { drive, stand, score } = run(demoMap(), 'line-entry-2026');
    drive(0, 6);
    stand(6, 5);
    expect(score()).toBe(10 + 15 + 10 + 15);
  });
});

describe('a line that ends in the evacuation zone', () => {
  it('gives the tiles up to there, 10 for each victim that is moved and 30 more for each in safety, and is done with the last', () => {
    const zone = tileOf('ev1', 0, {});
    const map = mapFile({ '0,0,0': straight(), '1,0,0': straight(), '2,0,0': zone, '2,1,0': zone }, { victims: { live: 2, dead: 0 } });
    const { drive, look, score, referee } = run(map, 'line-entry-2026');
    drive(0, 1);
    expect(look({ x: 750, y: 750 })).toBeNull();
    expect(score()).toBe(5);
    const of = { living: 2, dead: 0 };
    referee.see({ living: 1, dead: 0, moved: 1, of });
    look({ x: 750, y: 750 });
    expect([score(), referee.isDone]).toEqual([5 + 20 + 30, false]);
    referee.see({ living: 2, dead: 0, moved: 0, of });
    look({ x: 750, y: 750 });
    expect([score(), referee.isDone]).toEqual([5 + 20 + 60, true]);
  });
}); // prettier-ignore

describe('victims', () => {
  const zone = tileOf('ev1', 0, {});
  const map = mapFile(
    { '0,0,0': straight(), '1,0,0': straight(), '2,0,0': zone, '2,1,0': zone, '1,1,0': zone, '3,1,0': straight(0, { checkPoint: true }), '4,1,0': exit(90) },
    { width: 5, startTile2: { x: 3, y: 1, z: 0 } },
  ); // prettier-ignore

  it('multiply all points: each living one by 1.4, a dead one once all living ones are in safety', () => {
    const { drive, stand, look, referee, score } = run(map);
    drive(0, 1);
    expect(look({ x: 750, y: 450 })).toBeNull();
    const of = { living: 2, dead: 1 };
    referee.see({ living: 1, dead: 1, moved: 0, of });
    drive(2, 3);
    stand(3, 5);
    expect(score()).toBe(Math.round(1.4 * (5 + 10 + 5 + 60)));
    referee.see({ living: 2, dead: 1, moved: 0, of });
    expect(score()).toBe(Math.round(1.4 * 1.4 * 1.4 * 80));
  });

  it('are worth less after a lack of progress in their section, but never less than 1.25', () => {
    const { drive, referee } = run(map);
    drive(0, 1);
    for (const factor of [1.35, 1.3]) {
      referee.lack();
      referee.see({ living: 1, dead: 0, moved: 0, of: { living: 1, dead: 0 } });
      expect(referee.points().factor).toBeCloseTo(factor, 9);
    }
  });
});

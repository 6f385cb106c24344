import type { SceneObject } from '../src/scene/scene';
import { expect, warmTest as test } from './app';
import { block, comesTo, ends, line, objectsIn, opened, places, wall, type Drawer } from './drawer';
import { by, until } from './parts';
import { toolButton } from './pupil';
import { tablet, withFingers } from './touch';

/*
 * The twelve tasks of `twelve-tasks.test.ts` with nothing but a finger, on a tablet held upright. A tap, a drag and a
 * number that is typed are one gesture each.
 */

test.use(tablet);

type Page = Parameters<typeof withFingers>[0];

const begun = async (page: Page, ...objects: readonly SceneObject[]): Promise<Drawer> =>
  opened((await withFingers(page)).app, ...objects);

test('by finger: these two things 10 cm to the right: 4 gestures', async ({ page }) => {
  const hand = await begun(page, block('a', [200, 200]), wall('w', [300, 300], [300, 500]));
  await hand.click(by('several'));
  await hand.clickAt([200, 200]);
  await hand.clickAt([300, 400]);
  await until(hand.app, by('remove'));
  await hand.drag([[200, 200], [250, 200], [300, 200]]); // prettier-ignore
  await comesTo(hand.app, (all) => [places(all), ends(all)], [[[300, 200], null], [null, [[400, 300], [400, 500]]]]); // prettier-ignore
  expect(hand.count()).toBe(4);
});

test('by finger: everything 10 cm to the right: 2 gestures', async ({ page }) => {
  const hand = await begun(page, block('a', [200, 200]), block('b', [300, 500]));
  await hand.click('[aria-label^="Select all"]');
  await until(hand.app, by('remove'));
  await hand.drag([[200, 200], [250, 200], [300, 200]]); // prettier-ignore
  await comesTo(hand.app, places, [[300, 200], [400, 500]]); // prettier-ignore
  expect(hand.count()).toBe(2);
});

test('by finger: five equal walls, 20 cm apart: 9 gestures', async ({ page }) => {
  const hand = await begun(page);
  await hand.click(toolButton('wall'));
  await hand.drag([[100, 300], [100, 400], [100, 500]]); // prettier-ignore
  await hand.click(toolButton('select'));
  await hand.clickAt([100, 400]);
  await hand.click(by('duplicate'));
  await comesTo(hand.app, (all) => all.length, 2);
  await hand.drag([[120, 400], [200, 400], [300, 400]]); // prettier-ignore
  for (let more = 0; more < 3; more += 1) await hand.click(by('duplicate'));
  const walls = (all: readonly SceneObject[]) => all.flatMap((one) => (one.type === 'wall' ? [one] : []));
  await comesTo(hand.app, (all) => walls(all).length, 5);
  const lefts = walls(await objectsIn(hand.app)).map(({ from }) => from[0]);
  expect(lefts.slice(1).map((left, i) => left - (lefts[i] ?? 0))).toEqual([200, 200, 200, 200]);
  expect(hand.count()).toBe(9);
});

test('by finger: this corner four times: 5 gestures', async ({ page }) => {
  const hand = await begun(page, wall('w', [100, 600], [100, 700]), wall('v', [100, 700], [200, 700]));
  await hand.drag([[50, 550], [150, 650], [250, 750]]); // prettier-ignore
  await until(hand.app, by('remove'));
  for (let copy = 0; copy < 4; copy += 1) await hand.click(by('duplicate'));
  await comesTo(hand.app, (all) => all.filter(({ type }) => type === 'wall').length, 10);
  expect(hand.count()).toBe(5);
});

test('by finger: a target in the middle of the field: 2 gestures', async ({ page }) => {
  const hand = await begun(page);
  await hand.click(toolButton('zone'));
  await hand.clickAt([604, 447]);
  await comesTo(hand.app, places, [[600, 450]]); // prettier-ignore
  expect(hand.count()).toBe(2);
});

test('by finger: swap the places of two blocks: 3 gestures', async ({ page }) => {
  const hand = await begun(page, block('a', [300, 300]), block('b', [700, 300]));
  await hand.drag([[300, 300], [500, 400], [500, 600]]); // prettier-ignore
  await hand.drag([[700, 300], [500, 300], [300, 300]]); // prettier-ignore
  await hand.drag([[500, 600], [600, 400], [700, 300]]); // prettier-ignore
  await comesTo(hand.app, places, [[700, 300], [300, 300]]); // prettier-ignore
  expect(hand.count()).toBe(3);
});

test('by finger: a block twice as wide: 2 gestures', async ({ page }) => {
  const hand = await begun(page, { ...block('a', [300, 300]), size: [200, 200] } as SceneObject);
  await hand.clickAt([300, 300]);
  await until(hand.app, by('remove'));
  await hand.drag([[400, 400], [500, 400], [600, 400]]); // prettier-ignore
  await comesTo(hand.app, (all) => all.map((one) => ('size' in one ? one.size : null)), [[400, 200]]); // prettier-ignore
  expect(hand.count()).toBe(2);
});

test('by finger: three blocks in one row: 3 gestures', async ({ page }) => {
  const hand = await begun(page, block('a', [300, 300]), block('b', [500, 340]), block('c', [700, 380]));
  await hand.drag([[200, 200], [500, 300], [800, 500]]); // prettier-ignore
  await hand.click(by('selection-more'));
  await hand.click(by('menu-bottom'));
  await comesTo(hand.app, places, [[300, 300], [500, 300], [700, 300]]); // prettier-ignore
  expect(hand.count()).toBe(3);
});

test('by finger: a wall from exactly the corner of another: 2 gestures', async ({ page }) => {
  const hand = await begun(page, wall('w', [303, 303], [303, 607]), wall('v', [303, 607], [600, 607]));
  await hand.click(toolButton('wall'));
  await hand.drag([[606, 610], [605, 400], [606, 305]]); // prettier-ignore
  await comesTo(hand.app, (all) => (all[2]?.type === 'wall' ? all[2].from : null), [600, 607]); // prettier-ignore
  expect(hand.count()).toBe(2);
});

test('by finger: turn this maze by 90°: 3 gestures', async ({ page }) => {
  const hand = await begun(page, wall('w', [500, 400], [700, 400]), wall('v', [500, 500], [700, 500]));
  await hand.drag([[400, 300], [600, 500], [800, 650]]); // prettier-ignore
  await hand.click('[aria-label="Turn left"]');
  await hand.click('[aria-label="Turn left"]');
  await comesTo(hand.app, (all) => all.every((one) => one.type === 'wall' && one.from[0] === one.to[0]), true);
  expect(hand.count()).toBe(3);
});

test('by finger: take the middle out of a line: 2 gestures', async ({ page }) => {
  const hand = await begun(page, line('s', [200, 400], [600, 400]));
  await hand.click(toolButton('eraser'));
  await hand.drag([[400, 300], [400, 400], [400, 500]]); // prettier-ignore
  await comesTo(hand.app, (all) => all.length, 2);
  expect(hand.count()).toBe(2);
});

test('by finger: make a bend tighter: 3 gestures', async ({ page }) => {
  const hand = await begun(page, line('s', [200, 200], [500, 200], [500, 500]));
  await hand.doubleClickAt([300, 200]);
  await until(hand.app, by('points-done'));
  await hand.drag([[500, 200], [480, 250], [450, 300]]); // prettier-ignore
  const points = (all: readonly SceneObject[]): unknown => all.map((one) => ('points' in one ? one.points : null));
  await comesTo(hand.app, points, [[[200, 200], [450, 300], [500, 500]]]); // prettier-ignore
  expect(hand.count()).toBe(3);
});

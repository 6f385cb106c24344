import type { SceneObject } from '../src/scene/scene';
import { inWindow } from './arena';
import { expect, test } from './app';
import { block, comesTo, ends, line, objectsIn, opened, places, wall } from './drawer';
import { IN_ONE_ENGINE } from './engines';
import { isThere } from './page';
import { by, until } from './parts';
import { SIZE, toolButton } from './pupil';

/*
 * Thirteen tasks that a teacher has with a course, done as in a drawing program. Each counts its gestures: a click, a drag, a
 * key (with those that are held) and a number that is typed are one each. `docs/drawing-compared.md` has the counts of other
 * programs beside them.
 */

test('move these two things 10 cm to the right by keys: 12 gestures', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, block('a', [200, 200]), wall('w', [300, 300], [300, 500]));
  await hand.clickAt([200, 200]);
  await hand.clickAt([300, 400], 'Shift');
  for (let cm = 0; cm < 10; cm += 1) await hand.key('ArrowRight');
  await comesTo(app, (all) => [places(all), ends(all)], [[[300, 200], null], [null, [[400, 300], [400, 500]]]]); // prettier-ignore
  expect(hand.count()).toBe(12);
});

test('move everything 10 cm to the right: 2 gestures', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, block('a', [200, 200]), block('b', [300, 500]));
  await hand.key('Control', 'a');
  await until(app, by('remove')); // selected
  await hand.drag([[200, 200], [250, 200], [300, 200]]); // prettier-ignore
  await comesTo(app, places, [[300, 200], [400, 500]]); // prettier-ignore
  expect(hand.count()).toBe(2);
});

test('five equal walls, 20 cm apart: 7 gestures', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app);
  await hand.click(toolButton('wall'));
  await hand.drag([[100, 300], [100, 400], [100, 500]]); // prettier-ignore
  await hand.click(toolButton('select'));
  await hand.drag([[100, 400], [200, 400], [300, 400]], 'Alt'); // prettier-ignore
  for (let more = 0; more < 3; more += 1) await hand.key('Control', 'd');
  await comesTo(app, (all) => [...all].flatMap((one) => (one.type === 'wall' ? [[one.from[0], one.to[1] - one.from[1]]] : [])), [
    [100, 200], [300, 200], [500, 200], [700, 200], [900, 200],
  ]); // prettier-ignore
  expect(hand.count()).toBe(7);
});

test('copy this corner four times: 6 gestures', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, wall('w', [100, 600], [100, 700]), wall('v', [100, 700], [200, 700]));
  await hand.key('Control', 'a');
  await until(app, by('remove')); // selected
  await hand.clickAt([1100, 80], 'Shift'); // not the robot
  for (let copy = 0; copy < 4; copy += 1) await hand.key('Control', 'd');
  await comesTo(app, (all) => all.filter(({ type }) => type === 'wall').length, 10);
  const all = await objectsIn(app);
  const lefts = all.flatMap((one) => (one.type === 'wall' && one.from[0] === one.to[0] ? [one.from[0]] : []));
  expect(new Set(lefts.slice(1).map((left, i) => left - (lefts[i] ?? 0))).size).toBe(1); // equally far apart
  expect(hand.count()).toBe(6);
});

test('put a target in the middle of the field: 2 gestures', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app);
  await hand.click(toolButton('zone'));
  await hand.clickAt([604, 447]);
  await comesTo(app, places, [[600, 450]]); // prettier-ignore
  expect(hand.count()).toBe(2);
});

test('swap the places of two blocks: 3 gestures', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, block('a', [300, 300]), block('b', [700, 300]));
  await hand.drag([[300, 300], [500, 400], [500, 600]]); // prettier-ignore
  await hand.drag([[700, 300], [500, 300], [300, 300]]); // prettier-ignore
  await hand.drag([[500, 600], [600, 400], [700, 300]]); // prettier-ignore
  await comesTo(app, places, [[700, 300], [300, 300]]); // prettier-ignore
  expect(hand.count()).toBe(3);
});

test('make a block twice as wide: 2 gestures', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, { ...block('a', [300, 300]), size: [200, 200] } as SceneObject);
  await hand.clickAt([300, 300]);
  await hand.drag([[400, 300], [500, 300], [600, 300]]); // prettier-ignore
  await comesTo(app, (all) => all.map((one) => ('size' in one ? one.size : null)), [[400, 200]]); // prettier-ignore
  expect(hand.count()).toBe(2);
});

test('three blocks in one row: 3 gestures', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, block('a', [300, 300]), block('b', [500, 340]), block('c', [700, 380]));
  await hand.drag([[200, 200], [500, 300], [800, 500]]); // prettier-ignore
  await hand.click(by('selection-more'));
  await hand.click(by('menu-bottom'));
  await comesTo(app, places, [[300, 300], [500, 300], [700, 300]]); // prettier-ignore
  expect(hand.count()).toBe(3);
});

test('a wall from exactly the corner of another: 2 gestures', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, wall('w', [303, 303], [303, 607]), wall('v', [303, 607], [600, 607]));
  await hand.click(toolButton('wall'));
  await hand.drag([[606, 610], [605, 400], [606, 305]]); // prettier-ignore
  await comesTo(app, (all) => (all[2]?.type === 'wall' ? all[2].from : null), [600, 607]); // prettier-ignore
  expect(hand.count()).toBe(2);
});

test('turn this maze by 90°: 3 gestures', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, wall('w', [500, 400], [700, 400]), wall('v', [500, 500], [700, 500]));
  await hand.drag([[400, 300], [600, 500], [800, 650]]); // prettier-ignore
  await hand.click('[aria-label="Turn left"]');
  await hand.click('[aria-label="Turn left"]');
  await comesTo(app, (all) => all.every((one) => one.type === 'wall' && one.from[0] === one.to[0]), true);
  expect(hand.count()).toBe(3);
});

test('take the middle out of a line: 2 gestures', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, line('s', [200, 400], [600, 400]));
  await hand.click(toolButton('eraser'));
  await hand.drag([[400, 300], [400, 400], [400, 500]]); // prettier-ignore
  await comesTo(app, (all) => all.length, 2);
  expect(hand.count()).toBe(2);
});

test('make a bend of a line tighter: 3 gestures', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, line('s', [200, 200], [500, 200], [500, 500]));
  await hand.doubleClickAt([300, 200]);
  await until(app, by('points-done'));
  await hand.drag([[500, 200], [480, 250], [450, 300]]); // prettier-ignore
  await comesTo(app, (all) => all.map((one) => ('points' in one ? one.points : null)), [[[200, 200], [450, 300], [500, 500]]]); // prettier-ignore
  expect(hand.count()).toBe(3);
});

test('a bend on the end of a line, from the shelf of parts: 3 gestures', IN_ONE_ENGINE, async ({ app }) => {
  const hand = await opened(app, line('s', [200, 300], [450, 300]));
  await hand.click(by('course-more'));
  await hand.click(by('editor-parts'));
  await until(app, by('part-curve'));
  const from = await app.evaluate((css) => {
    const { left, top, width, height } = document.querySelector(css)!.getBoundingClientRect();
    return { x: left + width / 2, y: top + height / 2 };
  }, by('part-curve'));
  const way = await inWindow(app, SIZE, [[500, 400], [527, 377]]); // prettier-ignore
  await app.draw([from, ...way]);
  await comesTo(app, (all) => (all[1]?.type === 'stroke' ? [all[1].points[0], all[1].points.at(-1)] : null), [[450, 300], [600, 450]]); // prettier-ignore
  expect(await isThere(app, by('parts-shelf'))).toBe(true);
  expect(hand.count() + 1).toBe(3);
});

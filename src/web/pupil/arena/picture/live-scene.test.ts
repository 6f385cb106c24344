import { describe, expect, it } from 'vitest';
import { defaultScene, type Scene, type Stroke, type Wall } from '#scene/scene';
import { liveScene, shownSize } from './live-scene';

const wall = (id: string, x = 100): Wall => ({ type: 'wall', id, from: [x, 0], to: [x, 500], thickness: 10 });
const line: Stroke = { type: 'stroke', id: 'l', points: [[0, 0], [90, 0]], width: 20, color: 'black' }; // prettier-ignore
const withObjects = (...objects: Scene['objects']): Scene => ({ ...defaultScene(), objects });

describe('a course that is changed while a run goes on', () => {
  it('is shown as it is while there is no run', () => {
    const course = withObjects(wall('a'));
    expect(liveScene(course, null)).toMatchObject({ scene: course, waiting: [], start: null });
  });

  it('has new lines at once, and new walls only from the next start on', () => {
    const live = liveScene(withObjects(wall('a'), wall('b'), line), withObjects(wall('a')));
    expect(live.scene.objects.map(({ id }) => id)).toEqual(['a', 'l']);
    expect(live.waiting.map(({ id }) => id)).toEqual(['b']);
  });

  it('keeps a wall that was taken away until the next start', () => {
    const live = liveScene(withObjects(), withObjects(wall('a'), line));
    expect(live.scene.objects.map(({ id }) => id)).toEqual(['a']);
    expect([...live.leaving]).toEqual(['a']);
  });

  it('shows a wall that was moved at both places, and at one when it was moved back', () => {
    const started = withObjects(wall('a'));
    const moved = liveScene(withObjects(wall('a', 300)), started);
    expect([[...moved.leaving], moved.waiting]).toEqual([['a'], [wall('a', 300)]]);
    const back = liveScene(withObjects(wall('a')), started);
    expect([[...back.leaving], back.waiting]).toEqual([[], []]);
  });

  it('keeps the size of the arena and of the robot, and tells another start', () => {
    const started = withObjects();
    const robot = { ...started.robot, at: [300, 300] as const, scale: 2 };
    const live = liveScene({ ...started, size: [500, 500], robot }, started);
    expect(live.scene.size).toEqual([1200, 900]);
    expect(live.scene.robot.scale).toBe(1);
    expect(live.start).toEqual(robot);
  });

  it('has the size it began with until the next start, and shows where a larger one will end', () => {
    const started = defaultScene();
    const now = liveScene({ ...started, size: [2000, 500] }, started);
    expect(now.scene.size).toEqual(started.size);
    expect(now.size).toEqual([2000, 500]);
    expect(shownSize(now)).toEqual([2000, started.size[1]]);
    expect(liveScene({ ...started }, started).size).toBeNull();
  });
});

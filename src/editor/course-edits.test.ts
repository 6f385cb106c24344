import { describe, expect, it } from 'vitest';
import { editProblem } from '#scene/check-edit';
import { applyEdit, type SceneEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';
import { cleared, described, named, withSize } from './course-edits';
import { block, course, footprint } from './testing/desk';

function done(scene: Scene, edit: SceneEdit | null): Scene {
  if (!edit) throw new Error('nothing to do');
  expect(editProblem(scene, edit)).toBeNull();
  return applyEdit(scene, edit);
}

describe('the course as a whole', () => {
  it('gets a name of at most 200 characters and a description', () => {
    expect(done(course(), named(course(), '  Slalom ')).name).toBe('Slalom');
    expect(done(course(), named(course(), 'x'.repeat(300))).name).toHaveLength(200);
    expect(done(course(), described(course(), 'Fahr\num die Kurve.')).description).toBe('Fahr\num die Kurve.');
    expect(named(course(), '')).toBeNull();
  });

  it('gets another size from 200 mm to 10 m; the robot is brought inside, in the same step', () => {
    const small = done(course(), withSize(course(), [500, 400], footprint));
    expect(small.size).toEqual([500, 400]);
    expect(small.robot.at).toEqual([440, 370]);
    expect(done(course(), withSize(course(), [5, 99_999], footprint)).size).toEqual([200, 10_000]);
    expect(withSize(course(), [1200, 900])).toBeNull();
  });

  it('is cleared of objects', () => {
    expect(done(course(block('b', [1, 1])), cleared(course(block('b', [1, 1])))).objects).toEqual([]);
    expect(cleared(course())).toBeNull();
  });
});

import { describe, expect, it } from 'vitest';
import { projectWith, sceneWith, targetAt } from '../testing/tasks';
import { taskOf } from './read-task';

/** The problem reported for a task whose hidden world has this input. */
function problemWith(input: unknown): string {
  const worlds = [{ id: 'w', inputs: [input] }];
  const read = taskOf({ ...projectWith(sceneWith([targetAt(600, 450)])), task: { version: 1, worlds } });
  return 'problem' in read ? read.problem : '';
}

const FORM =
  'An input of a task is like { "timeUs": 1000000, "action": { "type": "button", "button": "a", "down": true } }.';

describe('an input of a task', () => {
  it('is refused with its place and the right form if it is written otherwise; nobody has recorded it', () => {
    expect(problemWith({ at: '1s', button: 'a', down: true })).toBe(`task.worlds[0].inputs[0]: is no input. ${FORM}`);
    const button = { type: 'button', button: 'c', down: true };
    expect(problemWith({ timeUs: 5, action: button })).toBe(
      `task.worlds[0].inputs[0].action.button: "c" does not belong here. ${FORM}`,
    );
    expect(problemWith({ timeUs: 5, action: { ...button, button: 'a' } })).toBe('');
  });
});

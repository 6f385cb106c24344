import { expect, it } from 'vitest';
import { handInOfFiles } from './hand-in/read-hand-in';
import { rehearse } from './rehearse';
import { ahead, checked, firmware, sceneWith, targetAt, taskWith } from './testing/tasks';

const task = taskWith(sceneWith([targetAt(700, 450)]));

it('ends although the program never does, and changes no result', async () => {
  const before = await checked(task, ahead(4000));
  await rehearse(task, handInOfFiles([{ name: 'main.py', text: 'while True:\n    pass\n' }]), { firmware: firmware() });
  expect(await checked(task, ahead(4000))).toEqual(before);
});

import { expect, it } from 'vitest';
import { sceneWith, taskWith, targetAt } from '../testing/tasks';
import { groupsHtmlOf } from './groups-html';

it('a report by groups has a picture, a sentence and a hint for each, and no tags from texts', () => {
  const task = taskWith(sceneWith([targetAt(700, 450)]));
  const { id: world } = task.worlds[0];
  const trail = [[[200, 450], [700, 450]]] as const; // prettier-ignore
  const ways = { world, trails: [trail, trail], tone: 'wrong', example: trail, mark: { at: [700, 450], radius: 10, text: '<here>' } } as const; // prettier-ignore
  const group = { title: '2 turn <late>', fact: 'at 2 s', ways, hint: 'too small' };
  const html = groupsHtmlOf({ task: 'T', handIns: [] }, task, 'en', [group]);
  expect(html).toContain('2 turn &lt;late&gt;');
  expect(html).toContain('<p>at 2 s</p><p>too small</p>');
  expect(html).toContain('&lt;here&gt;');
  expect(html.match(/<polyline fill="none" stroke="#c3262b"/g)).toHaveLength(2);
});

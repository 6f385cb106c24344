import type { Project } from '#project/project';
import { targetAt, projectWith, readyScene, sceneWith } from '../../testing/tasks';
import { plainWorld } from '../../task/task';
import type { Series } from '../series';

/** The ready courses that links in tests name. */
export const readyCourses = (id: string) => (id === 'closed-line' ? readyScene(id) : null);

/** A task of a teacher: with a solution, a hidden world and a lock. */
export const teachersTask = (name = 'Zum Ziel'): Project => ({
  ...projectWith(sceneWith([targetAt(600, 500)], { name }), 'forward()\n'),
  task: {
    version: 1,
    id: 'ziel',
    checks: [{ type: 'goals', id: 'goals' }],
    worlds: [{ id: 'geheim', hidden: true, seed: plainWorld.seed ?? 7 }],
    solution: [{ name: 'main.py', text: '# Musterlösung\nforward()\n' }],
    locks: { course: true },
  },
});

/** A ready course, a task with everything, and a plain project. */
export const aSeries = (): Series => ({
  id: 'woche-3',
  title: 'Woche 3: Linien',
  text: 'Jede Aufgabe dauert etwa zehn Minuten.',
  tasks: [
    { id: '1', title: '', from: { kind: 'course', course: 'closed-line' } },
    { id: 'b', title: 'Ans Ziel', from: { kind: 'project', project: teachersTask() } },
    {
      id: '3',
      title: '',
      from: { kind: 'project', project: projectWith(sceneWith([targetAt(300, 300)], { name: 'Ohne Aufgabe' })) },
    },
  ],
});

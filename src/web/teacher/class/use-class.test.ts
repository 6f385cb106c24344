// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';

import { ahead, sceneWith, projectWith } from '#check/testing/tasks';
import { teachersTask } from '#check/series/testing/series';

import { LateModels } from '../../kit/state/late-models';
import { program } from './model/testing/class';
import { chooseTask, classOf } from './use-class';

const aPage = () => ({ late: new LateModels() });

describe('the class of a page', () => {
  it('is the same for whoever asks on it, and empty on the next page', async () => {
    const page = aPage();
    await classOf(page).add([program('Ada', ahead(3000))]);
    expect(classOf(page).rows.value.map(({ name }) => name)).toEqual(['Ada']);
    expect(classOf(aPage()).rows.value).toEqual([]);
  });

  it('is checked for the task of a project, and once for the same', () => {
    const model = classOf(aPage());
    const from = { name: 'Ziel', from: 'file' };
    expect(chooseTask(model, teachersTask(), from)).toBeNull();
    const chosen = model.task.value;
    expect(chosen).toMatchObject({ name: 'ziel', from: 'file' });
    chooseTask(model, teachersTask(), from);
    expect(model.task.value).toBe(chosen);
  });

  it('has no task any more where the project that is chosen has no goals, and says so', () => {
    const model = classOf(aPage());
    chooseTask(model, teachersTask(), { name: 'Ziel', from: 'file' });
    expect(chooseTask(model, projectWith(sceneWith([])), { name: 'Leer', from: 'file' })).not.toBeNull();
    expect(model.task.value).toBeNull();
  });
});

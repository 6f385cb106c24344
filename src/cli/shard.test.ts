import { describe, expect, it } from 'vitest';
import { isInShard, shardOf } from './shard';

describe('a part of the work', () => {
  it('is all of it, or one of several', () => {
    expect(shardOf(null, {})).toEqual({ place: 1, of: 1 });
    expect(shardOf('2/7', {})).toEqual({ place: 2, of: 7 });
  });

  it.each([
    ['Slurm', { SLURM_ARRAY_TASK_ID: '14', SLURM_ARRAY_TASK_MIN: '10', SLURM_ARRAY_TASK_STEP: '2', SLURM_ARRAY_TASK_COUNT: '4' }, 'auto', { place: 3, of: 4 }], // prettier-ignore
    ['Kubernetes', { JOB_COMPLETION_INDEX: '0' }, 'auto/7', { place: 1, of: 7 }],
    ['GitLab', { CI_NODE_INDEX: '3', CI_NODE_TOTAL: '5' }, 'auto', { place: 3, of: 5 }],
    ['CircleCI', { CIRCLE_NODE_INDEX: '3', CIRCLE_NODE_TOTAL: '5' }, 'auto', { place: 4, of: 5 }],
    ['Buildkite', { BUILDKITE_PARALLEL_JOB: '4', BUILDKITE_PARALLEL_JOB_COUNT: '5' }, 'auto', { place: 5, of: 5 }],
  ])('is what %s says', (_system, variables, text, shard) => {
    expect(shardOf(text, variables)).toEqual(shard);
  });

  it.each(['0/7', '8/7', '2', '1/0', 'x/7', '2/7/1', '1.5/2', '-1/2', ''])('is not %j', (text) => {
    expect(shardOf(text, {})).toHaveProperty('problem');
  });

  it('is asked for where nothing says how many there are', () => {
    expect(shardOf('auto', { JOB_COMPLETION_INDEX: '0' })).toEqual({
      problem: '--shard auto: JOB_COMPLETION_INDEX does not say of how many. Say so: --shard auto/7',
    });
  });

  it('is together with the others the whole, each thing once', () => {
    const things = Array.from({ length: 24 }, (_, at) => at);
    const parts = Array.from({ length: 7 }, (_, at) => things.filter((thing) => isInShard({ place: at + 1, of: 7 }, thing))); // prettier-ignore
    expect(parts.flat().toSorted((a, b) => a - b)).toEqual(things);
  });
});

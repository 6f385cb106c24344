/** A part of the work: every `of`-th piece, beginning with the `place`-th, 1 … `of`. */
export interface Shard {
  readonly place: number;
  readonly of: number;
}

/** The only part: all of it. */
const WHOLE: Shard = { place: 1, of: 1 };

/** Chosen: more parts than hand-ins in the largest course of a university. */
const MOST_SHARDS = 100_000;

type Variables = Readonly<Record<string, string | undefined>>;

/** Variables in which systems that run a command many times pass its number, the first number, and the count. */
const systems: readonly {
  readonly index: string;
  readonly first: (variables: Variables) => number;
  readonly step?: string;
  readonly count: string | null;
}[] = [
  // Slurm: sbatch, "Job array support".
  {
    index: 'SLURM_ARRAY_TASK_ID',
    first: (variables) => Number(variables['SLURM_ARRAY_TASK_MIN'] ?? 0),
    step: 'SLURM_ARRAY_TASK_STEP',
    count: 'SLURM_ARRAY_TASK_COUNT',
  },
  // Kubernetes: "Indexed Job"; how many there are it does not say.
  { index: 'JOB_COMPLETION_INDEX', first: () => 0, count: null },
  // GitLab CI: parallel.
  { index: 'CI_NODE_INDEX', first: () => 1, count: 'CI_NODE_TOTAL' },
  // CircleCI: parallelism.
  { index: 'CIRCLE_NODE_INDEX', first: () => 0, count: 'CIRCLE_NODE_TOTAL' },
  // Buildkite: parallel jobs.
  { index: 'BUILDKITE_PARALLEL_JOB', first: () => 0, count: 'BUILDKITE_PARALLEL_JOB_COUNT' },
];

/**
 * The part of the work that a command does.
 *
 * @param text `2/7`; `auto` or `auto/7`: from the variables of an array job; `null`: all of it
 */
export function shardOf(text: string | null, variables: Variables): Shard | { readonly problem: string } {
  if (text === null) return WHOLE;
  const [, place = '', of] = /^(\d+|auto)(?:\/(\d+))?$/.exec(text) ?? [];
  const shard = place === 'auto' ? shardOfJob(of, variables) : { place: Number(place), of: Number(of ?? 'none') };
  if ('problem' in shard) return shard;
  const fits = isCount(shard.of) && Number.isInteger(shard.place) && shard.place >= 1 && shard.place <= shard.of;
  return fits ? shard : { problem: `--shard: "${text}" is not like 2/7, the second of seven parts.` };
}

function shardOfJob(of: string | undefined, variables: Variables): Shard | { readonly problem: string } {
  const system = systems.find(({ index }) => variables[index] !== undefined);
  if (system === undefined)
    return {
      problem: `--shard auto: none of ${systems.map(({ index }) => index).join(', ')} is set. Say which part: --shard 2/7`,
    };
  const { index, first, step, count } = system;
  const parts = of ?? (count === null ? undefined : variables[count]);
  if (parts === undefined)
    return { problem: `--shard auto: ${index} does not say of how many. Say so: --shard auto/7` };
  const steps = Number((step === undefined ? undefined : variables[step]) ?? 1);
  return { place: (Number(variables[index]) - first(variables)) / steps + 1, of: Number(parts) };
}

const isCount = (of: number): boolean => Number.isInteger(of) && of >= 1 && of <= MOST_SHARDS;

/** True if the item at this place, from 0, belongs to a part. */
export const isInShard = ({ place, of }: Shard, at: number): boolean => at % of === place - 1;

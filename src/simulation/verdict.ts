/** How well the robot does what the course asks for (`Zone`, `Spikes`, `Task` of `#scene/scene`), as plain data. */
export interface Verdict {
  /** `passed` and `failed` are final: nothing that happens later changes them. */
  readonly state: 'open' | 'passed' | 'failed';
  /** Simulated ms when it was decided, or `null` as long as it is open. */
  readonly atMs: number | null;
  /** Why it failed, or `null`. */
  readonly reason: 'time' | 'forbidden' | 'spikes' | 'touched' | null;
  /** Id of the object that was touched, or `null`: the arena's edge, or none. */
  readonly by: string | null;
  readonly checkpoints: { readonly passed: number; readonly of: number };
  /** Targets for the robot: how many it has come to. */
  readonly targets: { readonly reached: number; readonly of: number };
  /** Blocks that lie in targets, of those wanted. */
  readonly blocks: { readonly delivered: number; readonly of: number };
  /** How often walls, blocks, the edge or obstacles were touched. */
  readonly touches: number;
}

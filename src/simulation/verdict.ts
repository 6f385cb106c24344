/** How well the robot does the course's task (`Zone`, `Spikes`, `Task` of `#scene/scene`), as plain data. */
export interface Verdict {
  /** `passed` and `failed` are final: later events do not change them. */
  readonly state: 'open' | 'passed' | 'failed';
  /** Simulated ms of the decision, or `null` while it is open. */
  readonly atMs: number | null;
  /** Why it failed, or `null`. */
  readonly reason: 'time' | 'forbidden' | 'spikes' | 'touched' | null;
  /** Id of the object that was touched, or `null` for the arena's edge or nothing. */
  readonly by: string | null;
  readonly checkpoints: { readonly passed: number; readonly of: number };
  /** Targets for the robot: the number that it has reached. */
  readonly targets: { readonly reached: number; readonly of: number };
  /** Number of blocks in targets, and of wanted blocks. */
  readonly blocks: { readonly delivered: number; readonly of: number };
  /** Number of touches of walls, blocks, the edge or obstacles. */
  readonly touches: number;
}

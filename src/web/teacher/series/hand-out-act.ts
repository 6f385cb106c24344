/** A way to hand something out. */
export interface HandOutAct {
  readonly icon: string;
  readonly text: string;
  readonly testId: string;
  readonly isOff?: boolean;
  readonly act: () => void;
}

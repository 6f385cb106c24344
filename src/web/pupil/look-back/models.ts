import type { JoinModels } from '../../session/models/session';

/** Refuses changes of course and devices while looking back, by whichever way they come, and says so. */
export const join: JoinModels = ({ work, run, notices }) => {
  work.staysAsItIs = () => {
    if (run.past.value === null) return false;
    void import('./explain-standstill').then(({ explainStandstill }) => explainStandstill(notices));
    return true;
  };
};

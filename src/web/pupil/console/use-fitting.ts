import { usePage } from '../../kit/parts';
import type { Notice } from '../../kit/notices';
import { useRun } from '../../session/run/parts';
import { useDevice } from '../../session/work/hardware/use-device';
import { useWork } from '../../session/work/model/parts';

type Action = NonNullable<Notice['action']>;

/** The mismatch of the device that is shown, and its remedies as buttons of the console. */
export function useFitting() {
  const app = { ...usePage(), ...useRun(), ...useWork() };
  const { misplugged, offer } = useDevice(app);
  /** The same action, and then the program runs again, if the robot fits now. */
  const again = (action: Action): Action => ({
    ...action,
    run: () => {
      action.run();
      if (offer.value === null) app.run.press();
    },
  });
  return { misplugged, offer, again };
}

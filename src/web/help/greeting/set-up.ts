import { watch } from 'vue';

import type { SetUp } from '../../session/models/session';
import { firstStepsOf } from '../parts';
import { useGreeting } from './use-greeting';

/** Gives the greeting the card's place in the layout. */
export const setUp: SetUp = (session) => {
  const isGreeted = useGreeting({ ...session, ...firstStepsOf(session) });
  watch(isGreeted, (isOn) => (session.layout.isGreeting.value = isOn), { immediate: true, flush: 'sync' });
};

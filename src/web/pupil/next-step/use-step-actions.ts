import { latePart } from '../../kit/late-part';
import { causeOfEnd } from '../console/error-text';
import type { StepAction } from './next-step';
import { pressGuard } from './press-guard';
import type { StepApp } from './step-app';

/** Does what the bar's button says. A second press within a second does nothing. */
export function useStepActions(app: StepApp): (action: StepAction) => void {
  const { run, hand, task, mode, layout } = app;
  const again = (): void => {
    hand.reset();
    void run.reset();
  };
  const toMissions = (): void => app.router.open('missions', task.ready.value?.mission?.robot);
  const actions: Readonly<Record<StepAction, () => void>> = {
    run: () => run.press(),
    hint() {
      task.open();
      task.hints.value += 1;
    },
    'own-hint'() {
      task.open();
      task.own.level.value += 1;
    },
    mission: () => void openNext(app).catch(() => app.notices.show(latePart)),
    stars: toMissions,
    missions: toMissions,
    'hand-in': () => task.handIn.open(),
    again,
    restart: again,
    change() {
      const place = causeOfEnd(run.ended.value, app);
      if (place !== null) app.jump.to(place);
      layout.tab.value = 'code';
    },
    try() {
      mode.enter('drive');
      run.press();
    },
  };
  const guard = pressGuard();
  return (action) => guard(actions[action]);
}

/** Opens the mission after this one. */
async function openNext(app: StepApp): Promise<void> {
  const mission = app.task.ready.value?.mission;
  const [missions, courses] = await Promise.all([
    import('#catalogue/missions'),
    import('../../session/work/use-courses'),
  ]);
  const next = mission === undefined ? null : missions.missionAfter(mission);
  if (next !== null) courses.useCourses(app).openAgain(next);
}

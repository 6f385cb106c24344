import type { LeagueRules } from '#scene/league/league';
import type { Scene } from '#scene/scene';
import { pointRules } from './rules';

/** A course that is scored by other rules, with their time limit if it has the usual one; one without a league stays as it is. */
export function scoredBy(scene: Scene, rules: LeagueRules): Scene {
  const { league, task } = scene;
  if (league === undefined || league.rules === rules) return scene;
  const isUsual = task.seconds === pointRules[league.rules].seconds;
  const seconds = isUsual ? pointRules[rules].seconds : task.seconds;
  return { ...scene, task: { ...task, seconds }, league: { ...league, rules } };
}

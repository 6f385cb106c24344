import type { JoinModels } from '../../session/models/session';
import { tellIdleHand } from './tell-idle-hand';

/** The place to which the hand has put the robot can become the course's start. */
export const join: JoinModels = (session) => tellIdleHand(session);

# The way out of the room
# First the robot turns once around and draws a map: a bar for each direction, as long as the way is free.
# Then it looks for the door, and behind the door for what is too low for row 3 of the lidar.
from mbrobot_plusV3 import *

STEP = 20               # degrees from one look to the next
DOOR = 80               # centimetres: no wall of the room is so far away
LOW = 24                # centimetres in row 6: the floor is 30 away, so here lies something

def free_way():
    """Centimetres that are free ahead, as wide as the robot."""
    return min(getDistanceRow(3)[2:6])

def more_on_the_right():
    """Columns in which the door is open on the right, minus those on the left."""
    is_open = [distance > DOOR for distance in getDistanceRow(3)]
    return sum(is_open[4:]) - sum(is_open[:4])

for i in range(360 // STEP):
    print(i * STEP, "#" * (free_way() // 5))
    pidControlAngle(STEP, 1)

while free_way() < DOOR:
    pidControlAngle(STEP, 1)
more = more_on_the_right()
while abs(more) > 1:                    # until the door is in the middle
    pidControlAngle(4 if more > 0 else -4, 1)
    more = more_on_the_right()

pidControlDistance(1, 200, 0)           # straight ahead, without waiting for the end
while min(getDistanceRow(6)[2:6]) > LOW:
    delay(20)
pidControlStop()
pidControlAngle(60, 1)                  # around what lies there
pidControlDistance(1, 35, 1)
pidControlAngle(-60, 1)
pidControlDistance(1, 40, 1)

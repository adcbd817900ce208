"""Routes of forward dynamics, which are algorithms of their own in firmware/apps/size/matrix.txt: forward_dynamics_<route>."""

JOB = "forward_dynamics"
TAGS = {"articulated_body": "ArticulatedBody", "split_articulated_body": "SplitArticulatedBody", "composite_body": "CompositeBody"}


def route_of(algorithm):
    """Its name, or None where the algorithm names none."""
    name = algorithm.removeprefix(JOB + "_")
    return name if name != algorithm and name in TAGS else None


def job_of(algorithm):
    """The algorithm, whatever its route."""
    return JOB if route_of(algorithm) else algorithm

#include <BulletDynamics/Featherstone/btMultiBody.h>

#include <cmath>
#include <stability/peers/bullet_module.hpp>

namespace {

btScalar number(double x) { return static_cast<btScalar>(x); }
btVector3 vector(const double* v) { return {number(v[0]), number(v[1]), number(v[2])}; }

// Its links' frames stand in the centres of mass.
void add(btMultiBody& body, int i, const double* link, const btVector3& parent_com) {
  const double alpha = link[1], a = link[2], d = link[3];
  const btQuaternion to_link(btVector3(1, 0, 0), number(-alpha));
  const btVector3 pivot(number(a), number(-d * std::sin(alpha)), number(d * std::cos(alpha)));
  const btVector3 com = vector(link + 5), moments = vector(link + 8), axis(0, 0, 1);
  const bool collision = true;
  if (link[0] == 0.0)
    body.setupRevolute(i, number(link[4]), moments, i - 1, to_link, axis, pivot - parent_com, com, collision);
  else
    body.setupPrismatic(i, number(link[4]), moments, i - 1, to_link, axis, pivot - parent_com, com, collision);
}

}  // namespace

void axial_bullet_accelerations(int links, const double* chain, const double* gravity, const double* q,
                                const double* qd, const double* tau, double* qdd) {
  btMultiBody body(links, 0, btVector3(0, 0, 0), true, false);
  btVector3 com(0, 0, 0);
  for (int i = 0; i < links; ++i) {
    const double* link = chain + i * bullet_numbers_a_link;
    add(body, i, link, com);
    com = vector(link + 5);
  }
  body.finalizeMultiDof();
  body.setLinearDamping(0), body.setAngularDamping(0);
  body.setMaxCoordinateVelocity(number(1e30));
  for (int i = 0; i < links; ++i)
    body.setJointPos(i, number(q[i])), body.setJointVel(i, number(qd[i]));
  btAlignedObjectArray<btQuaternion> rotations;
  btAlignedObjectArray<btVector3> origins;
  body.forwardKinematics(rotations, origins);
  body.clearForcesAndTorques();
  for (int i = 0; i < links; ++i) {
    body.addJointTorque(i, number(tau[i]));
    body.addLinkForce(i, number(chain[i * bullet_numbers_a_link + 4]) * vector(gravity));
  }
  btAlignedObjectArray<btScalar> scalars;
  btAlignedObjectArray<btVector3> vectors;
  btAlignedObjectArray<btMatrix3x3> matrices;
  body.computeAccelerationsArticulatedBodyAlgorithmMultiDof(number(1e-3), scalars, vectors, matrices, false, false,
                                                            false);
  for (int i = 0; i < links; ++i)
    qdd[i] = static_cast<double>(scalars[links + 6 + i]);  // after N efforts and the base's six
}

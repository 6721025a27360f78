! J2 plasticity with the equations of j2.h as a VUMAT in Fortran.
module j2_law
  use iso_c_binding
  implicit none
  integer(c_short), bind(C, name="vumat_nMaterialProperties") :: number_of_constants = 4
  integer(c_short), bind(C, name="vumat_nInternalStateVariables") :: number_of_states = 7
contains
  pure function full(a) result(m)
    real(8), intent(in) :: a(6)
    real(8) :: m(3, 3)
    m(1, 1) = a(1); m(2, 2) = a(2); m(3, 3) = a(3)
    m(1, 2) = a(4); m(2, 3) = a(5); m(3, 1) = a(6)
    m(2, 1) = a(4); m(3, 2) = a(5); m(1, 3) = a(6)
  end function
  pure function short(m) result(a)
    real(8), intent(in) :: m(3, 3)
    real(8) :: a(6)
    a = [m(1, 1), m(2, 2), m(3, 3), m(1, 2), m(2, 3), m(3, 1)]
  end function
  pure function det(m) result(d)
    real(8), intent(in) :: m(3, 3)
    real(8) :: d
    d = m(1, 1)*(m(2, 2)*m(3, 3) - m(2, 3)*m(3, 2)) - m(1, 2)*(m(2, 1)*m(3, 3) - m(2, 3)*m(3, 1)) &
        + m(1, 3)*(m(2, 1)*m(3, 2) - m(2, 2)*m(3, 1))
  end function
  pure function inverse(m) result(b)
    real(8), intent(in) :: m(3, 3)
    real(8) :: b(3, 3)
    integer :: i, j, i1, i2, j1, j2
    do j = 1, 3
      do i = 1, 3
        i1 = mod(i, 3) + 1; i2 = mod(i + 1, 3) + 1; j1 = mod(j, 3) + 1; j2 = mod(j + 1, 3) + 1
        b(j, i) = m(i1, j1)*m(i2, j2) - m(i1, j2)*m(i2, j1)
      end do
    end do
    b = b/det(m)
  end function
end module

subroutine vumat(nblock, ndir, nshr, nstatev, nfieldv, nprops, lanneal, stepTime, totalTime, dt, cmname, coordMp, &
                 charLength, props, density, strainInc, relSpinInc, tempOld, stretchOld, defgradOld, fieldOld, stressOld, &
                 stateOld, enerInternOld, enerInelasOld, tempNew, stretchNew, defgradNew, fieldNew, stressNew, stateNew, &
                 enerInternNew, enerInelasNew)
  use j2_law
  implicit none
  integer :: nblock, ndir, nshr, nstatev, nfieldv, nprops, lanneal
  real(8) :: stepTime, totalTime, dt
  character*80 :: cmname
  real(8) :: coordMp(nblock, 3), charLength(nblock), props(nprops), density(nblock), strainInc(nblock, ndir + nshr), &
    relSpinInc(nblock, nshr), tempOld(nblock), stretchOld(nblock, ndir + nshr), defgradOld(nblock, ndir + 2*nshr), &
    fieldOld(nblock, nfieldv), stressOld(nblock, ndir + nshr), stateOld(nblock, nstatev), enerInternOld(nblock), &
    enerInelasOld(nblock), tempNew(nblock), stretchNew(nblock, ndir + nshr), defgradNew(nblock, ndir + 2*nshr), &
    fieldNew(nblock, nfieldv), stressNew(nblock, ndir + nshr), stateNew(nblock, nstatev), enerInternNew(nblock), &
    enerInelasNew(nblock)
  real(8), parameter :: one(3, 3) = reshape([1d0, 0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 0d0, 1d0], [3, 3])
  real(8) :: U(3, 3), V(3, 3), s(3, 3), back(3, 3), mu, bulk, J, scale, mean, now, trial, limit, gam, shrink, half, cube, &
    grown, alpha, lost, density0, step
  integer :: l, i
  mu = props(1)/(2*(1 + props(2)))
  bulk = props(1)/(3*(1 - 2*props(2)))
  do l = 1, nblock
    U = full(stretchNew(l, :))
    V = full(stretchOld(l, :))
    J = det(U)
    scale = exp(-2d0/3d0*log(J))
    s = scale*matmul(U, matmul(full(stateOld(l, 1:6)) + one, U))
    mean = (s(1, 1) + s(2, 2) + s(3, 3))/3
    s = s - mean*one
    alpha = stateOld(l, 7)
    trial = mu*sqrt(sum(s*s))
    limit = sqrt(2d0/3d0)*(props(3) + props(4)*alpha)
    now = mean
    lost = 0
    stateNew(l, 1:6) = stateOld(l, 1:6)
    if (trial > limit) then
      gam = (trial - limit)/(2*mu*mean + 2d0/3d0*props(4))
      shrink = (trial - 2*mu*mean*gam)/trial
      s = shrink*s
      half = sum(s*s)/2
      cube = det(s)
      do i = 1, 60 ! det(s + now 1) = 1, from above
        step = (now**3 - half*now + cube - 1)/(3*now**2 - half)
        now = now - step
        if (.not. step > 1d-15) exit
      end do
      back = inverse(U)
      stateNew(l, 1:6) = short(matmul(back, matmul((s + now*one)/scale, back)) - one)
      grown = sqrt(2d0/3d0)*gam
      lost = (props(3) + props(4)*(alpha + grown/2))*grown*3*now*(now - 1.5d0*cube/half)/(3*now**2 - half)
      alpha = alpha + grown
    end if
    stateNew(l, 7) = alpha
    stressNew(l, :) = short(mu*s + 0.5d0*bulk*(J**2 - 1)*one)/J
    density0 = density(l)*0.5d0*(det(V) + J)
    enerInelasNew(l) = enerInelasOld(l) + lost/density0
    enerInternNew(l) = (0.5d0*bulk*(0.5d0*(J**2 - 1) - log(J)) + 1.5d0*mu*(now - 1))/density0 + enerInelasNew(l)
  end do
end subroutine
